#include "own.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "physics/solver.h"

namespace carom::bench {
namespace {

// Ticks in a run: about the same number of ball ticks for every number of balls, and a warm-up.
RunPlan plan_for(std::size_t balls) {
    const auto measured = static_cast<std::int64_t>(std::max<std::size_t>(4, 1'000'000 / balls));
    const std::int64_t warm = 2 + measured / 5;
    return {.ticks = warm + measured, .measured_from = warm, .sample_every = warm + measured};
}

struct Case {
    SolverKind solver;
    std::size_t balls;
    double rate = 60.0;
    std::vector<double> costs = {};   // s a tick
    std::vector<double> speeds = {};  // collisions a second
    double heap = 0.0;
};

void run_once(const Places& places, Case& now) {
    SceneList list;
    list.plan = plan_for(now.balls);
    // A tick at one tick a second simulates as much as 60 ticks at the usual rate.
    if (now.rate < 60.0) list.plan = {.ticks = 8, .measured_from = 1, .sample_every = 8};
    const std::string path = places.scratch + "/own.list";
    std::ofstream(path) << scene_list_text(list);
    auto run =
        run_engine(places, "bench_carom", path, "-",
                   {places.scenes + "/gas.level", fmt::format("let n={}", now.balls),
                    fmt::format("rate {}", now.rate), fmt::format("solver {}", name(now.solver))});
    if (!run) return;
    auto& figures = run->figures;
    now.costs.push_back(figures["seconds"] / figures["measured"]);
    now.speeds.push_back(figures["measured_collisions"] / figures["seconds"]);
    now.heap = figures["heap"];
}

}  // namespace

OwnFigures measure_own(const Places& places, bool quick, int rounds,
                       const std::function<void(const std::string&)>& say) {
    std::vector<std::size_t> sizes{1'000, 10'000};
    if (!quick) sizes.insert(sizes.end(), {100'000, 1'000'000});
    std::vector<Case> cases;
    for (const SolverKind solver : solvers_available()) {
        for (const std::size_t balls : sizes)
            cases.push_back({.solver = solver, .balls = balls});
    }
    for (const std::size_t balls : sizes)
        if (balls <= 100'000)
            cases.push_back({.solver = SolverKind::event, .balls = balls, .rate = 1.0});
    for (int round = 0; round < rounds; ++round) {
        for (Case& now : cases) {
            say(fmt::format("gas of {}, {} ticks a second: {}, run {}", now.balls, now.rate,
                            name(now.solver), round + 1));
            run_once(places, now);
        }
    }
    OwnFigures own;
    for (const Case& now : cases) {
        if (now.costs.empty()) continue;
        const auto balls = static_cast<double>(now.balls);
        if (now.rate == 60.0) {
            own.costs.push_back({.solver = std::string(name(now.solver)),
                                 .balls = now.balls,
                                 .ns_a_ball_tick = 1e9 * median(now.costs) / balls,
                                 .bytes_a_ball = now.heap / balls});
        }
        if (now.solver == SolverKind::event) {
            own.events.push_back(
                {.balls = now.balls, .rate = now.rate, .collisions_a_second = median(now.speeds)});
        }
    }
    return own;
}

}  // namespace carom::bench
