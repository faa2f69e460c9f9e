#include "game/replay/command_script.h"

#include <algorithm>
#include <utility>

#include "game/pool/pool.h"
#include "game/replay/replay_commands.h"
#include "game/replay/replay_words.h"
#include "game/shots/shots.h"
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
                                         "time-out",
                                         "concede"};

// Whether all balls lie still, and the last shot is over.
bool may_shoot(const World& world, const GameState& game) {
    if (!is_at_rest(world)) return false;
    const auto* const shots = std::get_if<ShotsState>(&game);
    // The first turn begins in the first tick.
    if (shots) return !shots->is_shooting && !shots->rules.turn_is_new;
    const auto* const pool = std::get_if<PoolPlay>(&game);
    return !pool || !pool->is_shooting;
}

// The ball that the player whose turn it is strikes; none: it is off the table, or there is no cue.
std::optional<BallId> struck_ball(const Scene& scene, const GameState& game) {
    if (const auto* const shots = std::get_if<ShotsState>(&game)) return cue_ball_of(scene, *shots);
    if (const auto* const pool = std::get_if<PoolPlay>(&game))
        return pool->balls[static_cast<std::size_t>(cue_ball)];
    if (!scene.pool.cue) return std::nullopt;
    return scene.pool.cue->ball;
}

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
    std::uint64_t last = 0;
    int line = 0;
    for (const std::string_view written : split_lines(text)) {
        ++line;
        const std::string content = words_of(written);
        if (content.empty()) continue;
        ScriptCommand made;
        Words words(content);
        if (words.next() != "at")
            return ReplayError{line, "a command begins with 'at' and its tick",
                               "write for example: at 120 gravity 0,-9.81"};
        made.waits_for_rest = words.rest().starts_with("rest ");
        if (made.waits_for_rest)
            words.next();
        else
            made.tick = words.integer<std::uint64_t>();
        if (words.failed())
            return ReplayError{line, "the tick is not a whole number from 0 to 2^64 - 1",
                               "write for example: at 120 gravity 0,-9.81; or at rest ..."};
        std::string rest(words.rest());
        constexpr std::string_view of_cue = "strike cue ";
        made.is_of_cue = rest.starts_with(of_cue);
        if (made.is_of_cue) rest.replace(0, of_cue.size(), "strike 0 ");
        words = Words(rest);
        const auto command = read_command(words);
        if (!command)
            return ReplayError{line, "there is no such command", advice_on(keyword_of(rest))};
        if (!words.done())
            return ReplayError{
                line, "'" + std::string(keyword_of(rest)) + "' is not complete or not right",
                advice_on(keyword_of(rest))};
        if (!made.waits_for_rest && made.tick < last)
            return ReplayError{line, "the ticks go back",
                               "put the commands in the order of their ticks"};
        last = std::max(last, made.tick);
        made.command = *command;
        script.commands.push_back(std::move(made));
        script.lines.push_back(line);
    }
    return script;
}

std::optional<ScriptRunner::Refused> ScriptRunner::execute_due(const Scene& scene, World& world,
                                                               GameState& game, Solver& solver) {
    for (; next_ < commands_.size(); ++next_) {
        ScriptCommand& next = commands_[next_];
        if (next.waits_for_rest ? !may_shoot(world, game) : next.tick > world.tick()) break;
        if (!next.waits_for_rest && next.tick < world.tick())
            return Refused{next_, next.tick,
                           "this tick is over: a command above it waited for rest"};
        next.tick = world.tick();
        if (next.is_of_cue) {
            const auto ball = struck_ball(scene, game);
            if (!ball) return Refused{next_, next.tick, "there is no cue ball to strike"};
            std::get<command::Strike>(next.command).ball = *ball;
        }
        const Command& command = next.command;
        if (auto reason = refusal(scene, world, game, command))
            return Refused{next_, next.tick, *std::move(reason)};
        if (const auto* change = std::get_if<command::SetSolver>(&command))
            if (!(change->settings == solver.settings())) solver = Solver(change->settings);
        execute(scene, world, game, command);
    }
    return std::nullopt;
}

std::vector<TimedCommand> ScriptRunner::executed() const {
    return {commands_.begin(), commands_.begin() + static_cast<std::ptrdiff_t>(next_)};
}

std::vector<ScriptCommand> as_script(std::span<const TimedCommand> commands) {
    std::vector<ScriptCommand> script;
    for (const TimedCommand& command : commands)
        script.push_back({command});
    return script;
}

}  // namespace carom
