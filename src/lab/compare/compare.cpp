#include "lab/compare/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "lab/measure/difference.h"
#include "lab/measure/nudge.h"

namespace carom {
namespace {

// The RMS difference from which the two runs are unrelated, in radii.
constexpr double elsewhere = 1.0;
// Where exponential growth saturates, in radii: balls this far apart hit different partners.
constexpr double saturation = 0.1;

struct Runner {
    Solver solver;
    World world;
    std::vector<Meeting> meetings;
    std::uint64_t period = 1;  // ticks between two comparisons
};

Runner runner_of(const Scene& scene, const Choice& choice, double common) {
    Runner runner{Solver(choice.solver), scene.world, {}, ticks_each(choice.rate, common)};
    runner.world.edit_definition().rate = choice.rate;
    return runner;
}

// Returns false if it was interrupted.
bool run_period(Runner& runner, const std::function<bool()>& keep_going) {
    for (std::uint64_t i = 0; i < runner.period; ++i) {
        if (runner.solver.tick(runner.world, keep_going) == TickOutcome::cancelled) return false;
        note_meetings(runner.meetings, runner.solver.contacts());
    }
    return keep_going();
}

// Returns the RMS difference.
double note_difference(Comparison& comparison, const World& first, const World& second,
                       double time) {
    const Difference off = difference(first, second);
    const DifferenceAt apart{time, off.rms / comparison.radius, off.max / comparison.radius};
    comparison.differences.push_back(apart);
    if (!comparison.divergence && apart.max > comparison.tolerance && off.farthest) {
        const Vec2 place = first.balls().position[*index_of(first, *off.farthest)];
        comparison.divergence = {time, *off.farthest, place, apart.max};
    }
    return apart.rms;
}

}  // namespace

Comparison compare(const Scene& scene, const CompareSettings& settings, const GoOn& go_on) {
    Comparison comparison{.first = settings.first,
                          .second = settings.second,
                          .radius = mean_radius(scene.world),
                          .tolerance = settings.tolerance};
    const std::array rates{settings.first.rate, settings.second.rate};
    const double common = common_rate(rates);
    Runner first = runner_of(scene, settings.first, common);
    Runner second = runner_of(scene, settings.second, common);
    if (settings.nudge > 0.0)
        nudge(second.world, settings.nudge * comparison.radius, scene.world.seed(), 0);

    note_difference(comparison, first.world, second.world, 0.0);
    const auto periods =
        static_cast<std::uint64_t>(std::llround(std::max(1.0, settings.time * common)));
    for (std::uint64_t i = 1; i <= periods && !comparison.is_lost; ++i) {
        const auto keep_going = [&] { return go_on(i, periods); };
        comparison.is_interrupted =
            !run_period(first, keep_going) || !run_period(second, keep_going);
        if (comparison.is_interrupted) break;
        const double time = static_cast<double>(i) / common;
        comparison.is_lost =
            !(note_difference(comparison, first.world, second.world, time) <= elsewhere);
    }

    // Where the runs diverged, a contact that only one of them had is the cause.
    const double together = comparison.time() - 2.0 / common;
    const double until =
        comparison.divergence ? std::max(comparison.divergence->time, together) : together;
    comparison.contact = first_difference(first.meetings, second.meetings, until);
    // Without divergence the difference is rounding, and its growth means nothing.
    if (comparison.divergence) {
        std::vector<GrowthPoint> points;
        for (const DifferenceAt& apart : comparison.differences)
            points.push_back({apart.time, apart.rms});
        comparison.growth = exponential_growth(points, saturation);
    }
    return comparison;
}

}  // namespace carom
