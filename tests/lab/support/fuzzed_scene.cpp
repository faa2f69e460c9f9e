#include "lab/support/fuzzed_scene.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "bits/level_writer.h"
#include "bits/recording_writer.h"
#include "game/replay/command_script.h"
#include "game/replay/replay_commands.h"
#include "game/session/game_state.h"
#include "level/load.h"
#include "physics/solver.h"

namespace carom::test {

FuzzedScene fuzzed_scene(std::uint64_t number, double least_decade) {
    bits::Random random(number);
    const bool is_played = random.chance(0.5);
    bits::Level level = bits::write_level(random, least_decade);
    level.radius = std::min(level.width, level.height) / 20.0;
    std::string commands;
    if (is_played)
        for (const bits::TimedLine& line : bits::write_commands(random, level))
            // Another solver promises something else.
            if (!line.command.starts_with("solver "))
                commands += "at " + std::to_string(line.tick) + ' ' + line.command + '\n';
    return scene_of(level.text, commands, static_cast<std::uint64_t>(level.ticks));
}

FuzzedScene scene_of(std::string level, const std::string& commands, std::uint64_t ticks) {
    FuzzedScene made;
    made.text = std::move(level);
    made.ticks = ticks;
    made.scene = load_level(made.text, "fuzzed.level").scene;
    auto read = read_script(commands);
    if (auto* script = std::get_if<CommandScript>(&read))
        made.script.assign(script->commands.begin(), script->commands.end());
    return made;
}

CheckedRun check_run(const FuzzedScene& fuzzed, SolverKind kind) {
    const Scene& scene = *fuzzed.scene;
    World world = scene.world;
    GameState game = begin_game(scene);
    SolverSettings settings = scene.solver.value_or(SolverSettings{});
    settings.kind = kind;
    Solver solver(settings);
    InvariantCheck check(scene, kind);
    CheckedRun run;
    std::size_t next = 0;
    while (run.ticks < fuzzed.ticks && !run.breach) {
        for (; next < fuzzed.script.size() && fuzzed.script[next].tick == world.tick(); ++next) {
            const Command& command = fuzzed.script[next].command;
            if (refusal(scene, world, game, command)) continue;
            execute(scene, world, game, command);
            run.commands +=
                "at " + std::to_string(world.tick()) + ' ' + replay_text(command) + '\n';
        }
        check.note_start(world);
        const TickOutcome outcome = solver.tick(world);
        run.stood_still = run.stood_still || outcome == TickOutcome::stood_still;
        run.breach = check.note_tick(world, outcome == TickOutcome::stood_still, solver.contacts());
        update_game(scene, world, game, solver.contacts());
        ++run.ticks;
    }
    return run;
}

}  // namespace carom::test
