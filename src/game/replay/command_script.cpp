#include "game/replay/command_script.h"

#include <utility>

#include "game/replay/replay_commands.h"
#include "game/replay/replay_words.h"
#include "level/text/text.h"

namespace carom {
namespace {

/// The line without its comment, and with one blank between words.
std::string words_of(std::string_view line) {
    std::string text;
    bool is_between = false;
    for (const char c : line.substr(0, line.find('#'))) {
        const bool is_blank = c == ' ' || c == '\t';
        if (!is_blank && is_between && !text.empty()) text += ' ';
        if (!is_blank) text += c;
        is_between = is_blank;
    }
    return text;
}

// An example of each command, for messages.
constexpr std::string_view examples[] = {"strike 0 1.5,-2",
                                         "hold-ball 3 10,20",
                                         "drop-ball 3",
                                         "hold-edge 2 0,0 10,5",
                                         "drop-edge 2",
                                         "place-ball 3 4,5",
                                         "place-edge 2 0,0 10,6",
                                         "add-ball 0 5,5 1,0",
                                         "remove-ball 4",
                                         "add-edge 0 0,0 10,0 0.5 both",
                                         "remove-edge 5",
                                         "gravity 0,-9.81",
                                         "solver swept",
                                         "press left",
                                         "release left",
                                         "pull 0.25",
                                         "launch 0.25",
                                         "call pot 3 1",
                                         "decide take-table",
                                         "rack",
                                         "time-out"};

std::string_view keyword_of(std::string_view command) {
    return command.substr(0, command.find(' '));
}

std::string advice_on(std::string_view keyword) {
    for (const std::string_view example : examples)
        if (keyword_of(example) == keyword)
            return "write for example: at 120 " + std::string(example);
    std::string all = "there are:";
    for (const std::string_view example : examples)
        all.append(" ").append(keyword_of(example));
    return all;
}

}  // namespace

std::span<const std::string_view> command_examples() {
    return examples;
}

std::variant<CommandScript, ReplayError> read_script(std::string_view text) {
    CommandScript script;
    int line = 0;
    for (const std::string_view written : split_lines(text)) {
        ++line;
        const std::string content = words_of(written);
        if (content.empty()) continue;
        Words words(content);
        if (words.next() != "at")
            return ReplayError{line, "a command begins with 'at' and its tick",
                               "write for example: at 120 gravity 0,-9.81"};
        const auto tick = words.integer<std::uint64_t>();
        if (words.failed())
            return ReplayError{line, "the tick is not a whole number from 0 to 2^64 - 1",
                               "write for example: at 120 gravity 0,-9.81"};
        const std::string_view rest = words.rest();
        const auto command = read_command(words);
        if (!command)
            return ReplayError{line, "there is no such command", advice_on(keyword_of(rest))};
        if (!words.done())
            return ReplayError{
                line, "'" + std::string(keyword_of(rest)) + "' is not complete or not right",
                advice_on(keyword_of(rest))};
        if (!script.commands.empty() && tick < script.commands.back().tick)
            return ReplayError{line, "the ticks go back",
                               "put the commands in the order of their ticks"};
        script.commands.push_back({tick, *command});
        script.lines.push_back(line);
    }
    return script;
}

std::optional<ScriptRunner::Refused> ScriptRunner::execute_due(const Scene& scene, World& world,
                                                               GameState& game, Solver& solver) {
    while (next_ < commands_.size() && commands_[next_].tick == world.tick()) {
        const Command& command = commands_[next_].command;
        if (auto reason = refusal(scene, world, game, command))
            return Refused{next_, *std::move(reason)};
        if (const auto* change = std::get_if<command::SetSolver>(&command))
            if (!(change->settings == solver.settings())) solver = Solver(change->settings);
        execute(scene, world, game, command);
        ++next_;
    }
    return std::nullopt;
}

}  // namespace carom
