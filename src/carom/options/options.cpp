#include "carom/options/options.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "carom/options/option_list.h"
#include "carom/options/option_values.h"
#include "carom/text/suggest.h"
#include "carom/text/version.h"

// What was typed, understood, and what to say where it cannot be.
namespace carom {
namespace {

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

RunOptions run_options(const TypedOptions& typed, OptionReader& read) {
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

MeasureOptions measure_options(const TypedOptions& typed, OptionReader& read) {
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

CompareOptions compare_options(const TypedOptions& typed, OptionReader& read) {
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

PlayOptions play_options(const TypedOptions& typed, OptionReader& read) {
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

Request understood(const CLI::App* command, const TypedOptions& typed) {
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
    TypedOptions typed;
    add_commands(app, typed);
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
