#include "carom/options/option_list.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>

#include "carom/options/option_values.h"
#include "physics/solver.h"

namespace carom {
namespace {

using Text = const std::string&;

/// A row of the option list. `value` names the option's argument; empty for a flag.
struct Row {
    const char* name;
    const char* value;
    std::string help;
};

/// Adds options to one command.
class Command {
  public:
    explicit Command(CLI::App& app) : app_(app) {}
    Command(CLI::App& app, const char* name, const char* help)
        : app_(*app.add_subcommand(name, help)) {}

    CLI::App& app() { return app_; }

    /// `parse` turns the option's name and its argument into the value.
    template <class Target, class Parse>
    void add(const Row& row, Target& target, const Parse& parse) {
        const auto take = [&target, parse, option = row.name](Text text) {
            target = parse(option, text);
        };
        app_.add_option_function<std::string>(row.name, take, row.help)->type_name(row.value);
    }
    void add(const Row& row, std::string& target) {
        app_.add_option(row.name, target, row.help)->type_name(row.value);
    }
    void add(const Row& row, bool& target) { app_.add_flag(row.name, target, row.help); }

    void add_level(std::string& level) {
        app_.add_option("LEVEL", level, "A file, or the name of a level that ships")
            ->type_name("")
            ->required();
    }
    void add_level_or_recording(std::string& level) {
        app_.add_option("LEVEL", level, "A file, the name of a level that ships, or a recording")
            ->type_name("")
            ->required();
    }
    void add_file(std::string& file) {
        app_.add_option("FILE", file, "A recording, as --record makes them")
            ->type_name("")
            ->required();
    }
    void add_overrides(std::vector<std::string>& overrides) {
        app_.add_option("--set", overrides,
                        "A level statement that overrides the file's, as in 'use gravity 0,-1.6'; "
                        "may stand several times")
            ->type_name("STATEMENT")
            ->expected(1)
            ->allow_extra_args(false)
            ->take_all();
    }
    /// --rate, --seed and --set.
    template <class Options>
    void add_level_options(Options& options);
    /// --solver, --rate, --seed and --set.
    template <class Options>
    void add_simulation_options(Options& options);

  private:
    CLI::App& app_;
};

auto number(double least, double most) {
    return [=](std::string_view option, Text text) {
        return number_in({least, most}, option, text);
    };
}

auto count(std::uint64_t least, std::uint64_t most) {
    return [=](std::string_view option, Text text) {
        return static_cast<int>(whole_number_in(least, most, option, text));
    };
}

auto rates(std::string_view option, Text text) {
    return numbers_in(rate_range, option, text);
}

template <class Options>
void Command::add_level_options(Options& options) {
    add({"--rate", "HZ", "Ticks a second"}, options.rate,
        number(rate_range.least, rate_range.most));
    add({"--seed", "N", "Starts the level's random stream"}, options.seed, whole_number);
    add_overrides(options.overrides);
}

template <class Options>
void Command::add_simulation_options(Options& options) {
    add({"--solver", "NAME", solver_names() + ", or auto (the default)"}, options.solver,
        solver_choice);
    add_level_options(options);
}

void add_view_options(Command& command, PlayOptions& play) {
    command.add({"--renderer", "NAME", renderer_names() + ", or auto (the default)"}, play.renderer,
                renderer_option);
    command.add({"--colors", "N", "mono, 8, 16, 256, truecolor, or auto (the default)"},
                play.colors, color_choice);
    command.add({"--theme", "NAME", "dark, light, contrast, color-blind, or auto (the default)"},
                play.theme, theme_option);
    command.add({"--fps", "N", "Frames a second"}, play.fps, number(1, 1000));
    command.app().add_flag_callback(
        "--no-mouse", [&play] { play.mouse = false; }, "Leave the mouse to the terminal");
    command.add({"--low-bandwidth", "", "15 frames a second, ASCII and no trails, for slow links"},
                play.low_bandwidth);
    command.add({"--paused", "", "Start paused"}, play.paused);
    command.add({"--rewind", "MIB", "Most memory for stepping back, in MiB"}, play.rewind_bytes,
                bytes_of_mebibytes);
    command.add({"--cast", "FILE", "Film the screen, for asciinema play"}, play.cast);
}

void add_guest(CLI::App& app, GuestOptions& guest) {
    Command carom(app);
    carom.add({"--guest", "NAME", "Play as a guest of this account, in a folder of its own"},
              guest.name, guest_name);
    carom.add({"--guest-saves", "N", "Levels that the guest may keep; 20 by default"},
              guest.most_saves, count(1, 10000));
    carom.add({"--guest-idle", "TIME", "End after so long without input, as in 600s; 1800s"},
              guest.idle, idle_time);
    carom.add({"--guest-sessions", "N", "Sessions of the guest at a time; 2 by default"},
              guest.most_sessions, count(1, 100));
}

void add_play(CLI::App& app, PlayOptions& options) {
    Command play(app, "play", "Play a level in the terminal");
    play.app()
        .add_option("LEVEL", options.level,
                    "A file, or the name of a level that ships; absent: the menu")
        ->type_name("");
    play.add_simulation_options(options);
    add_view_options(play, options);
    play.add({"--record", "FILE", "Keep a recording, for carom replay and verify"}, options.record);
    play.add({"--watch", "", "Load the level again whenever its file is saved"}, options.watch);
    play.add(
        {"--opponent", "N", "At pool, carom plays the second player, 1 (beginner) to 4 (master)"},
        options.opponent, count(1, 4));
    play.add({"--demo", "", "At pinball, carom plays until you press a button of the table"},
             options.demo);
    play.add({"--resume", "", "Resume the unfinished game"}, options.resume);
}

void add_run(CLI::App& app, RunOptions& options) {
    Command run(app, "run", "Simulate a level without a screen");
    run.add_level_or_recording(options.level);
    run.add({"--time", "S",
             "Simulated seconds, rounded to whole ticks; 10, or a recording's, where neither is "
             "given"},
            options.time, number(0, 1e9));
    run.add({"--ticks", "N", "Ticks to simulate"}, options.ticks, whole_number);
    run.add_simulation_options(options);
    run.add({"--commands", "FILE", "What to do at which tick, as in 'at 120 drop-edge 2'"},
            options.commands);
    run.add({"--report", "FILE", "What came of it, as one JSON object"}, options.report);
    run.add({"--events", "FILE", "Every contact, one JSON object a line"}, options.events);
    run.add({"--log", "FILE", "What the rules of the level did, a line a tick"}, options.log);
    run.add({"--trace", "FILE", "Every ball at every tick, as CSV"}, options.trace);
    run.add({"--curves", "FILE", "The curves of what the level observes, as CSV"}, options.curves);
    run.add({"--record", "FILE", "A recording, for carom replay and verify"}, options.record);
    run.add({"--check", "", "Check energy, sides, overlap and time after every tick"},
            options.check);
    run.add({"--explain", "", "Say which physics is in force, and which solver runs and why"},
            options.explain);
    run.app().footer("FILE may be -, standard output, for one of them.");
}

void add_replay_and_verify(CLI::App& app, PlayOptions& play, VerifyOptions& options) {
    Command replay(app, "replay", "Watch a recording in the terminal");
    Command verify(app, "verify",
                   "Play a recording without a screen and compare its fingerprints: exit code 0 "
                   "or 1");
    replay.add_file(play.replay);
    verify.add_file(options.file);
    add_view_options(replay, play);
}

void add_measure(CLI::App& app, MeasureOptions& options) {
    Command measure(app, "measure",
                    "Measure what every solver costs on a level, and how far it is off");
    measure.add_level_or_recording(options.level);
    measure.add(
        {"--time", "S", "Simulated seconds; 2, or all of a recording, where nothing is said"},
        options.time, number(1e-6, 1e6));
    measure.add({"--solvers", "A,B...", "Those to try, of " + solver_names()}, options.solvers,
                solvers_of_measure);
    measure.add({"--rates", "HZ,HZ...",
                 "Ticks a second to try; a quarter to four times the level's where nothing is "
                 "said"},
                options.rates, rates);
    measure.add({"--repeats", "N", "Runs of each, for its cost; 3 where nothing is said"},
                options.repeats, count(1, 1000));
    measure.add({"--horizon", "S", "When errors are compared, in simulated seconds"},
                options.horizon, number(1e-6, 1e6));
    measure.add({"--tolerance", "R",
                 "Names the cheapest good one whose error is this or less, in ball radii"},
                options.tolerance, number(1e-15, 1e3));
    measure.add({"--budget", "TIME",
                 "Names the best that takes this or less for a tick of the level, as in "
                 "2ms"},
                options.budget, duration);
    measure.add_level_options(options);
    measure.add({"--csv", "FILE", "A row for each choice and horizon"}, options.csv);
    measure.add({"--json", "FILE", "All of it, as one JSON object"}, options.json);
    measure.app().footer("FILE may be -, standard output, for one of the two.");
}

void add_compare(CLI::App& app, CompareOptions& options) {
    Command compare(app, "compare", "Say when two solvers part, and how fast: exit code 0 or 1");
    compare.add_level(options.level);
    compare.add({"--solvers", "A,B",
                 "The two, of " + solver_names() + "; a rate may follow, as in swept@480"},
                options.solvers, two_solvers);
    compare.app().get_option("--solvers")->required();
    compare.add({"--time", "S", "Simulated seconds; 10 where nothing is said"}, options.time,
                number(1e-6, 1e9));
    compare.add({"--tolerance", "R",
                 "They part when a ball is further from its twin than this, in ball radii; 1e-3 "
                 "where nothing is said"},
                options.tolerance, number(1e-15, 1e3));
    compare.add(
        {"--nudge", "R", "Starts every ball of the second this far from its twin, in ball radii"},
        options.nudge, number(0, 1));
    compare.add_level_options(options);
    compare.add({"--json", "FILE", "All of it, as one JSON object; - is standard output"},
                options.json);
}

void add_picture(CLI::App& app, PictureOptions& options) {
    Command picture(app, "picture", "Write what the screen would show to a file");
    picture.add_level(options.level);
    picture.add({"--time", "S", "Simulated seconds before the picture; 0 by default"}, options.time,
                number(0, 1e6));
    picture.app()
        .add_option_function<std::string>(
            "--size",
            [&options](Text text) {
                const WindowSize window = window_size("--size", text);
                options.columns = window.columns;
                options.rows = window.rows;
            },
            "Columns and rows of the window; 80x24 by default")
        ->type_name("CxR");
    picture.add({"--format", "NAME", "svg, text, or ansi (the default)"}, options.format,
                picture_format);
    picture.add({"--output", "FILE", "The file; standard output by default"}, options.output);
    picture.add({"--renderer", "NAME", renderer_names() + ", or auto (the default)"},
                options.renderer, renderer_option);
    picture.add({"--colors", "N", "mono, 8, 16, 256, or truecolor (the default)"}, options.colors,
                color_choice);
    picture.add({"--theme", "NAME", "dark (the default), light, contrast, color-blind"},
                options.theme, theme_option);
    picture.add({"--demo", "", "Pinball: carom plays"}, options.demo);
    picture.add_simulation_options(options);
}

void add_new(CLI::App& app, NewOptions& options) {
    Command fresh(app, "new", "Write a level to begin with, or a copy of one that ships");
    fresh.app()
        .add_option("FILE", options.file, "A file that does not exist yet")
        ->type_name("")
        ->required();
    fresh.add({"--template", "LEVEL", "The level to copy: a file, or the name of one that ships"},
              options.source);
}

void add_explain(CLI::App& app, ExplainOptions& options) {
    Command explain(app, "explain", "Print what a statement of the level language takes");
    explain.app()
        .add_option("STATEMENT", options.words, "Its name, as in edge or use gravity; absent: all")
        ->type_name("");
}

void add_check_and_list(CLI::App& app, CheckOptions& options) {
    Command check(app, "check", "Say all that is wrong with levels: exit code 0 or 2");
    check.app()
        .add_option("LEVEL", options.levels,
                    "Files, names of levels that ship, or - for standard input")
        ->type_name("")
        ->required();
    check.add_overrides(options.overrides);
    check.add({"--format", "NAME", "json, or text (the default)"}, options.format, check_format);
    app.add_subcommand("list", "List the levels that ship");
}

}  // namespace

void add_commands(CLI::App& app, CommandOptions& options) {
    add_guest(app, options.guest);
    add_play(app, options.play);
    add_run(app, options.run);
    add_replay_and_verify(app, options.play, options.verify);
    add_measure(app, options.measure);
    add_compare(app, options.compare);
    add_check_and_list(app, options.check);
    add_explain(app, options.explain);
    add_new(app, options.fresh);
    add_picture(app, options.picture);
}

}  // namespace carom
