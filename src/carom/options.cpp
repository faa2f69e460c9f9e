#include "carom/options.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>

#include "carom/option_values.h"
#include "carom/suggest.h"
#include "carom/version.h"

namespace carom {
namespace {

// What was typed, before it is understood.
struct Typed {
    std::string level;
    std::vector<std::string> levels;
    std::string solver, rate, seed;
    std::vector<std::string> overrides;
    std::string time, ticks, report, events, trace, record, replay, cast;
    std::string solvers, rates, repeats, horizon, tolerance, budget, nudge, csv, json;
    std::string renderer, colors, fps, rewind, opponent;
    bool explain = false, no_mouse = false, low_bandwidth = false, watch = false, paused = false,
         resume = false, demo = false;
};

void add_set(CLI::App& command, Typed& typed) {
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

void add_level(CLI::App& command, Typed& typed) {
    command.add_option("LEVEL", typed.level, "A file, or the name of a level that ships")
        ->type_name("")
        ->required();
}

void add_level_options(CLI::App& command, Typed& typed) {
    command.add_option("--rate", typed.rate, "Ticks a second")->type_name("HZ");
    command.add_option("--seed", typed.seed, "Starts the level's random stream")->type_name("N");
    add_set(command, typed);
}

void add_simulation_options(CLI::App& command, Typed& typed) {
    command.add_option("--solver", typed.solver, solver_names() + ", or auto (the default)")
        ->type_name("NAME");
    add_level_options(command, typed);
}

void add_view_options(CLI::App& command, Typed& typed) {
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

void add_play(CLI::App& app, Typed& typed) {
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

void add_replay_and_verify(CLI::App& app, Typed& typed) {
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

void add_run(CLI::App& app, Typed& typed) {
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

void add_measure(CLI::App& app, Typed& typed) {
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

void add_compare(CLI::App& app, Typed& typed) {
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

void add_check_and_list(CLI::App& app, Typed& typed) {
    CLI::App& check =
        *app.add_subcommand("check", "Say all that is wrong with levels: exit code 0 or 2");
    check.add_option("LEVEL", typed.levels, "Files, or names of levels that ship")
        ->type_name("")
        ->required();
    add_set(check, typed);
    app.add_subcommand("list", "List the levels that ship");
}

UsageAnswer mistake(const CLI::App* command, std::string_view what) {
    const std::string call =
        command->get_parent() == nullptr ? "carom" : "carom " + command->get_name();
    return {.text = fmt::format("carom: error: {}\n       `{} --help` lists what there is\n", what,
                                call),
            .exit_code = 2};
}

// What CLI11 could make nothing of.
UsageAnswer unknown_option(const CLI::App* command, std::string_view spelling) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command->get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    }
    return mistake(command, fmt::format("there is no option '{}'{}", spelling,
                                        suggestion(spelling, {names.begin(), names.end()})));
}

UsageAnswer unknown_command(const CLI::App* app, std::string_view spelling) {
    const std::string meant = suggestion(
        spelling, {"play", "run", "replay", "verify", "measure", "compare", "check", "list"});
    const std::string what = fmt::format("there is no command '{}'", spelling);
    if (!meant.empty()) return mistake(app, what + meant);
    return mistake(app, fmt::format("{}; to play a level, write `carom play {}`", what, spelling));
}

UsageAnswer unknown_argument(const CLI::App* command, const std::string& argument) {
    const std::string_view spelling = std::string_view(argument).substr(0, argument.find('='));
    if (spelling.starts_with("-")) return unknown_option(command, spelling);
    if (command->get_parent() == nullptr) return unknown_command(command, spelling);
    return mistake(command, fmt::format("'{}' is one argument too many", spelling));
}

const CLI::App* chosen(const CLI::App& app) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return commands.empty() ? &app : commands.front();
}

RunOptions run_options(const Typed& typed, OptionReader& read) {
    if (!typed.time.empty() && !typed.ticks.empty()) {
        read.refuse("--time and --ticks cannot stand together");
    }
    return {.level = typed.level,
            .solver = read.solver(typed.solver),
            .rate = read.rate(typed.rate),
            .seed = read.whole("--seed", typed.seed),
            .overrides = typed.overrides,
            .time = read.number("--time", typed.time, {.least = 0, .most = 1e9}),
            .ticks = read.whole("--ticks", typed.ticks),
            .report = typed.report,
            .events = typed.events,
            .trace = typed.trace,
            .record = typed.record,
            .explain = typed.explain};
}

std::vector<SolverKind> kinds_of(const std::vector<CompareOptions::Side>& sides,
                                 OptionReader& read) {
    std::vector<SolverKind> kinds;
    for (const CompareOptions::Side& side : sides) {
        if (side.rate) read.refuse("--solvers of measure takes no rates: they come from --rates");
        kinds.push_back(side.kind);
    }
    return kinds;
}

MeasureOptions measure_options(const Typed& typed, OptionReader& read) {
    MeasureOptions options{
        .level = typed.level,
        .rate = read.rate(typed.rate),
        .seed = read.whole("--seed", typed.seed),
        .overrides = typed.overrides,
        .time = read.number("--time", typed.time, {.least = 1e-6, .most = 1e6}),
        .repeats = {},
        .rates = read.rates(typed.rates),
        .solvers = kinds_of(read.solvers(typed.solvers, 0), read),
        .horizon = read.number("--horizon", typed.horizon, {.least = 1e-6, .most = 1e6}),
        .tolerance = read.number("--tolerance", typed.tolerance, {.least = 1e-15, .most = 1e3}),
        .budget = read.duration("--budget", typed.budget),
        .csv = typed.csv,
        .json = typed.json};
    if (const auto repeats = read.whole("--repeats", typed.repeats)) {
        if (*repeats < 1 || *repeats > 1000) read.refuse("--repeats must be from 1 to 1000");
        options.repeats = static_cast<int>(*repeats);
    }
    return options;
}

CompareOptions compare_options(const Typed& typed, OptionReader& read) {
    return {.level = typed.level,
            .rate = read.rate(typed.rate),
            .seed = read.whole("--seed", typed.seed),
            .overrides = typed.overrides,
            .solvers = read.solvers(typed.solvers, 2),
            .time = read.number("--time", typed.time, {.least = 1e-6, .most = 1e9}),
            .tolerance = read.number("--tolerance", typed.tolerance, {.least = 1e-15, .most = 1e3}),
            .nudge = read.number("--nudge", typed.nudge, {.least = 0, .most = 1}),
            .json = typed.json};
}

PlayOptions play_options(const Typed& typed, OptionReader& read) {
    PlayOptions options{.level = typed.level,
                        .solver = read.solver(typed.solver),
                        .rate = read.rate(typed.rate),
                        .seed = read.whole("--seed", typed.seed),
                        .overrides = typed.overrides,
                        .renderer = read.renderer(typed.renderer),
                        .colors = read.colors(typed.colors),
                        .fps = read.number("--fps", typed.fps, {.least = 1, .most = 1000}),
                        .mouse = typed.no_mouse ? std::optional(false) : std::nullopt,
                        .low_bandwidth = typed.low_bandwidth,
                        .record = typed.record,
                        .replay = typed.replay,
                        .cast = typed.cast,
                        .demo = typed.demo,
                        .watch = typed.watch,
                        .paused = typed.paused,
                        .resume = typed.resume};
    if (const auto steadiness = read.whole("--opponent", typed.opponent)) {
        if (*steadiness < 1 || *steadiness > 4)
            read.refuse("--opponent is 1, 2, 3 or 4");
        else
            options.opponent = static_cast<int>(*steadiness);
    }
    if (!typed.record.empty() && typed.level.empty() && !typed.resume)
        read.refuse("--record needs to know the LEVEL");
    if (!typed.cast.empty() && (typed.cast == typed.record || typed.cast == typed.replay))
        read.refuse("--cast needs a file of its own");
    if (const auto mebibytes = read.number("--rewind", typed.rewind, {.least = 0, .most = 65536})) {
        options.rewind_bytes = static_cast<std::size_t>(*mebibytes * 1048576.0);
    }
    return options;
}

Request understood(const CLI::App* command, const Typed& typed) {
    OptionReader read;
    Request request;
    const std::string name = command->get_parent() == nullptr ? "" : command->get_name();
    if (name == "run") {
        request = run_options(typed, read);
    } else if (name == "measure") {
        request = measure_options(typed, read);
    } else if (name == "compare") {
        request = compare_options(typed, read);
    } else if (name == "verify") {
        request = VerifyOptions{.file = typed.replay};
    } else if (name == "check") {
        request = CheckOptions{.levels = typed.levels, .overrides = typed.overrides};
    } else if (name == "list") {
        request = ListOptions{};
    } else {
        request = play_options(typed, read);
    }
    if (read.mistake()) return mistake(command, *read.mistake());
    return request;
}

}  // namespace

Request parse_options(int count, const char* const* arguments) {
    CLI::App app(
        "carom: balls and edges in a terminal, on physics that can be trusted.\n"
        "Without a command it opens the menu.",
        "carom");
    app.set_version_flag("--version", fmt::format("carom {}", version()));
    app.footer(
        "`carom COMMAND --help` lists a command's options. The manual: man carom, and docs/.");
    Typed typed;
    add_play(app, typed);
    add_run(app, typed);
    add_replay_and_verify(app, typed);
    add_measure(app, typed);
    add_compare(app, typed);
    add_check_and_list(app, typed);
    app.require_subcommand(0, 1);
    app.allow_extras();
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        command->allow_extras();
    }
    try {
        app.parse(count, arguments);
    } catch (const CLI::CallForVersion&) {
        return UsageAnswer{.text = app.version() + "\n"};
    } catch (const CLI::CallForHelp&) {
        return UsageAnswer{.text = app.help()};
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string_view what = error.what();
        return mistake(chosen(app),
                       fmt::format("{} needs a value", what.substr(0, what.find(':'))));
    } catch (const CLI::ParseError& error) {
        for (const std::string& extra : chosen(app)->remaining()) {
            return unknown_argument(chosen(app), extra);
        }
        return mistake(chosen(app), error.what());
    }
    const CLI::App* command = chosen(app);
    const std::vector<std::string> unknown = app.remaining(true);
    if (!unknown.empty()) return unknown_argument(command, unknown.front());
    return understood(command, typed);
}

}  // namespace carom
