#include "carom/options/option_list.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "physics/solver.h"

namespace carom {
namespace {

void add_set(CLI::App& command, TypedOptions& typed) {
    command
        .add_option("--set", typed.overrides,
                    "A level statement that overrides the file's, as in 'use gravity 0,-1.6'; "
                    "may stand several times")
        ->type_name("STATEMENT")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
}

// "discrete, substep, swept".
std::string solver_names() {
    std::string names;
    for (const SolverKind kind : solvers_available())
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name(kind));
    return names;
}

void add_level(CLI::App& command, TypedOptions& typed) {
    command.add_option("LEVEL", typed.level, "A file, or the name of a level that ships")
        ->type_name("")
        ->required();
}

void add_level_options(CLI::App& command, TypedOptions& typed) {
    command.add_option("--rate", typed.rate, "Ticks a second")->type_name("HZ");
    command.add_option("--seed", typed.seed, "Starts the level's random stream")->type_name("N");
    add_set(command, typed);
}

void add_simulation_options(CLI::App& command, TypedOptions& typed) {
    command.add_option("--solver", typed.solver, solver_names() + ", or auto (the default)")
        ->type_name("NAME");
    add_level_options(command, typed);
}

void add_view_options(CLI::App& command, TypedOptions& typed) {
    command.add_option("--renderer", typed.renderer, "ascii, half, braille, or auto (the default)")
        ->type_name("NAME");
    command.add_option("--colors", typed.colors, "mono, 8, 16, 256, or auto (the default)")
        ->type_name("N");
    command.add_option("--fps", typed.fps, "Frames a second")->type_name("N");
    command.add_flag("--no-mouse", typed.no_mouse, "Leave the mouse to the terminal");
    command.add_flag("--low-bandwidth", typed.low_bandwidth,
                     "15 frames a second, ASCII and no trails, for slow links");
    command.add_flag("--paused", typed.paused, "Start paused");
    command.add_option("--rewind", typed.rewind, "Most memory for stepping back, in MiB")
        ->type_name("MIB");
    command.add_option("--cast", typed.cast, "Film the screen, for asciinema play")
        ->type_name("FILE");
}

void add_play(CLI::App& app, TypedOptions& typed) {
    CLI::App& play = *app.add_subcommand("play", "Play a level in the terminal");
    play.add_option("LEVEL", typed.level,
                    "A file, or the name of a level that ships; absent: the menu")
        ->type_name("");
    add_simulation_options(play, typed);
    add_view_options(play, typed);
    play.add_option("--record", typed.record, "Keep a recording, for carom replay and verify")
        ->type_name("FILE");
    play.add_flag("--watch", typed.watch, "Load the level again whenever its file is saved");
    play.add_option("--opponent", typed.opponent,
                    "At pool, carom plays the second player, 1 (beginner) to 4 (master)")
        ->type_name("N");
    play.add_flag("--demo", typed.demo,
                  "At pinball, carom plays until you press a button of the table");
    play.add_flag("--resume", typed.resume, "Take up the session that was cut off or left");
}

void add_replay_and_verify(CLI::App& app, TypedOptions& typed) {
    CLI::App& replay = *app.add_subcommand("replay", "Watch a recording in the terminal");
    CLI::App& verify = *app.add_subcommand(
        "verify",
        "Play a recording without a screen and compare its fingerprints: exit code 0 or 1");
    for (CLI::App* command : {&replay, &verify}) {
        command->add_option("FILE", typed.replay, "A recording, as --record makes them")
            ->type_name("")
            ->required();
    }
    add_view_options(replay, typed);
}

void add_run(CLI::App& app, TypedOptions& typed) {
    CLI::App& run = *app.add_subcommand("run", "Simulate a level without a screen");
    add_level(run, typed);
    run.add_option("--time", typed.time,
                   "Simulated seconds, rounded to whole ticks; 10 where neither is given")
        ->type_name("S");
    run.add_option("--ticks", typed.ticks, "Ticks to simulate")->type_name("N");
    add_simulation_options(run, typed);
    run.add_option("--report", typed.report, "What came of it, as one JSON object")
        ->type_name("FILE");
    run.add_option("--events", typed.events, "Every contact, one JSON object a line")
        ->type_name("FILE");
    run.add_option("--trace", typed.trace, "Every ball at every tick, as CSV")->type_name("FILE");
    run.add_option("--record", typed.record, "A recording without commands, for carom verify")
        ->type_name("FILE");
    run.add_flag("--explain", typed.explain,
                 "Say which physics is in force, and which solver runs and why");
    run.footer("FILE may be -, standard output, for one of them.");
}

void add_measure(CLI::App& app, TypedOptions& typed) {
    CLI::App& measure = *app.add_subcommand(
        "measure", "Measure what every solver costs on a level, and how far it is off");
    add_level(measure, typed);
    measure.add_option("--time", typed.time, "Simulated seconds; 2 where nothing is said")
        ->type_name("S");
    measure.add_option("--solvers", typed.solvers, "Those to try, of " + solver_names())
        ->type_name("A,B...");
    measure
        .add_option("--rates", typed.rates,
                    "Ticks a second to try; a quarter to four times the level's where nothing is "
                    "said")
        ->type_name("HZ,HZ...");
    measure
        .add_option("--repeats", typed.repeats,
                    "Runs of each, for its cost; 3 where nothing is said")
        ->type_name("N");
    measure
        .add_option("--horizon", typed.horizon, "When errors are compared, in simulated seconds")
        ->type_name("S");
    measure
        .add_option("--tolerance", typed.tolerance,
                    "Names the cheapest whose error is this or less, in ball radii")
        ->type_name("R");
    measure
        .add_option("--budget", typed.budget,
                    "Names the most accurate that takes this or less for a tick of the level, as "
                    "in 2ms")
        ->type_name("TIME");
    add_level_options(measure, typed);
    measure.add_option("--csv", typed.csv, "A row for each choice and horizon")->type_name("FILE");
    measure.add_option("--json", typed.json, "All of it, as one JSON object")->type_name("FILE");
    measure.footer("FILE may be -, standard output, for one of the two.");
}

void add_compare(CLI::App& app, TypedOptions& typed) {
    CLI::App& compare =
        *app.add_subcommand("compare", "Say when two solvers part, and how fast: exit code 0 or 1");
    add_level(compare, typed);
    compare
        .add_option("--solvers", typed.solvers,
                    "The two, of " + solver_names() + "; a rate may follow, as in swept@480")
        ->type_name("A,B")
        ->required();
    compare.add_option("--time", typed.time, "Simulated seconds; 10 where nothing is said")
        ->type_name("S");
    compare
        .add_option("--tolerance", typed.tolerance,
                    "They part when a ball is further from its twin than this, in ball radii; "
                    "1e-3 where nothing is said")
        ->type_name("R");
    compare
        .add_option("--nudge", typed.nudge,
                    "Starts every ball of the second this far from its twin, in ball radii")
        ->type_name("R");
    add_level_options(compare, typed);
    compare.add_option("--json", typed.json, "All of it, as one JSON object; - is standard output")
        ->type_name("FILE");
}

void add_check_and_list(CLI::App& app, TypedOptions& typed) {
    CLI::App& check =
        *app.add_subcommand("check", "Say all that is wrong with levels: exit code 0 or 2");
    check.add_option("LEVEL", typed.levels, "Files, or names of levels that ship")
        ->type_name("")
        ->required();
    add_set(check, typed);
    app.add_subcommand("list", "List the levels that ship");
}

}  // namespace

void add_commands(CLI::App& app, TypedOptions& typed) {
    add_play(app, typed);
    add_run(app, typed);
    add_replay_and_verify(app, typed);
    add_measure(app, typed);
    add_compare(app, typed);
    add_check_and_list(app, typed);
}

}  // namespace carom
