#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// Which commands and options there are, as `--help` lists them.
namespace carom {

/// What was typed, before it is understood.
struct TypedOptions {
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

/// `typed` must outlive the parsing.
void add_commands(CLI::App& app, TypedOptions& typed);

}  // namespace carom
