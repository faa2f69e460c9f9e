#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "judge.h"
#include "suite.h"

/// Runs engines as processes, by turns.
namespace carom::bench {

/// Folders.
struct Places {
    std::string programs;  ///< with bench_carom, bench_box2d, ...
    std::string scripts;   ///< the JavaScript engines with their packages; may be empty
    std::string scenes;    ///< benchmarks/scenes
    std::string scratch;   ///< for lists and frames
};

/// The output of one run. Figures by name: seconds, ticks, measured, heap, collisions.
struct RunFigures {
    std::string engine;  ///< as the program names itself
    std::map<std::string, double> figures;
};

/// None where the program is absent, failed, or took more than half an hour.
std::optional<RunFigures> run_engine(const Places& places, const std::string& program,
                                     const std::string& list, const std::string& frames,
                                     const std::vector<std::string>& arguments);

struct Result {
    Contestant contestant;
    std::string engine;
    std::vector<double> seconds;  ///< of each run: processor time of `measured` ticks
    double measured = 0.0;        ///< ticks
    double ticks = 0.0;
    std::vector<Accuracy> judged;  ///< of the first run; of each run where `arrangement` differs

    Accuracy accuracy() const;  ///< medians
    double median_seconds() const;
    double milliseconds_a_tick() const { return 1e3 * median_seconds() / measured; }
};

struct SceneResults {
    BenchScene scene;
    std::size_t balls = 0;
    std::vector<Result> results;      ///< in the order of the contestants
    std::vector<std::string> absent;  ///< contestants that did not run
    std::string error;                ///< why there are no results
};

double median(std::vector<double> values);

/// Runs all contestants by turns, quick ones `rounds` times, and slow ones less often (twice from
/// 10 s on, once from 30 s on). `say` reports each run.
SceneResults run_scene(const Places& places, const BenchScene& scene, int rounds,
                       const std::function<void(const std::string&)>& say);

}  // namespace carom::bench
