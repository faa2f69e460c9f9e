#include "game/replay/command_script.h"

#include <utility>

#include "game/replay/replay_commands.h"
#include "game/replay/replay_words.h"

namespace carom {
namespace {

/// The line without its comment, and with one blank between words.
std::string words_of(std::string_view line) {
    std::string text;
    bool is_between = false;
    for (const char c : line.substr(0, line.find('#'))) {
        const bool is_blank = c == ' ' || c == '\t' || c == '\r';
        if (!is_blank && is_between && !text.empty()) text += ' ';
        if (!is_blank) text += c;
        is_between = is_blank;
    }
    return text;
}

}  // namespace

std::variant<CommandScript, ReplayError> read_script(std::string_view text) {
    CommandScript script;
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        const std::string content = words_of(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
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
            return ReplayError{line, "there is no such command",
                               "docs/command-line.md lists the commands"};
        if (!words.done())
            return ReplayError{line,
                               "'" + std::string(rest.substr(0, rest.find(' '))) +
                                   "' is not complete or not right",
                               "docs/command-line.md lists the commands with their numbers"};
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
