#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "carom/options/play_options.h"
#include "physics/solver.h"

/// The parsed command line.
namespace carom {

/// `carom run LEVEL`. Paths: "-" is standard output; empty: not written.
struct RunOptions {
    std::string level;                     ///< or a recording
    std::string commands;                  ///< a script; empty: none
    std::optional<SolverSettings> solver;  ///< none: the level's, or else carom picks one
    std::optional<double> rate;            ///< ticks a second
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;  ///< level statements, from --set

    std::optional<double> time;  ///< s; without it and `ticks` 10, or to the end of a recording
    std::optional<std::uint64_t> ticks;
    std::string report;
    std::string events;
    std::string log;
    std::string trace;
    std::string curves;
    std::string record;
    bool check = false;
    bool explain = false;
};

/// `carom measure LEVEL`. Paths: "-" is standard output; empty: not written.
struct MeasureOptions {
    std::string level;
    std::optional<double> rate;  ///< of the level, ticks a second
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;

    std::optional<double> time;  ///< s
    std::optional<int> repeats;
    std::vector<double> rates;        ///< to measure, ticks a second; empty: the usual ones
    std::vector<SolverKind> solvers;  ///< to measure; empty: all
    std::optional<double> horizon;    ///< s
    std::optional<double> tolerance;  ///< ball radii
    std::optional<double> budget;     ///< s of computation per tick of the level
    std::string csv;
    std::string json;
};

/// `carom compare LEVEL`
struct CompareOptions {
    std::string level;
    std::optional<double> rate;  ///< of the level, ticks a second
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;

    /// One of the two solvers; its own rate if one was given, as in swept@480.
    struct Side {
        SolverKind kind = SolverKind::swept;
        std::optional<double> rate;
    };
    std::vector<Side> solvers;        ///< two
    std::optional<double> time;       ///< s
    std::optional<double> tolerance;  ///< ball radii
    std::optional<double> nudge;  ///< initial displacement of the second run's balls, ball radii
    std::string json;
};

/// `carom verify FILE`
struct VerifyOptions {
    std::string file;
};

/// `carom check LEVEL...`
enum class CheckFormat : std::uint8_t {
    text,  ///< for people: with the line, a caret and a suggested fix
    json   ///< for editors
};

struct CheckOptions {
    std::vector<std::string> levels;
    std::vector<std::string> overrides;
    CheckFormat format = CheckFormat::text;
};

enum class PictureFormat : std::uint8_t {
    ansi,  ///< text with colours, for a terminal
    svg,
    text  ///< characters alone
};

/// `carom picture LEVEL`
struct PictureOptions {
    std::string level;
    std::optional<SolverSettings> solver;
    std::optional<double> rate;  ///< ticks a second
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;

    double time = 0.0;  ///< s
    int columns = 80;
    int rows = 24;
    RendererChoice renderer = nullptr;
    ColorChoice colors = ColorChoice::automatic;  ///< 24-bit
    ThemeChoice theme;
    PictureFormat format = PictureFormat::ansi;
    std::string output = "-";  ///< "-": standard output
    bool demo = false;         ///< pinball: carom plays
};

/// `carom list`
struct ListOptions {};

/// `carom new FILE`
struct NewOptions {
    std::string file;
    std::string source;  ///< the level to copy; empty: one to begin with
};

/// `carom explain [STATEMENT]`
struct ExplainOptions {
    std::vector<std::string> words;  ///< of the statement's name, as in "use gravity"; none: all
};

/// The answer to the command line itself: help, the version, or an error.
struct UsageAnswer {
    std::string text;
    int exit_code = 0;  ///< 0: the text is for standard output; 2: for standard error
};

using Request = std::variant<PlayOptions, RunOptions, MeasureOptions, CompareOptions, VerifyOptions,
                             CheckOptions, ListOptions, PictureOptions, ExplainOptions, NewOptions,
                             UsageAnswer>;

/// Never throws or exits: an error is a UsageAnswer with exit code 2.
Request parse_options(int count, const char* const* arguments);

}  // namespace carom
