#include "game/ai/pinball_plunge.h"

#include <algorithm>

#include "game/ai/pinball_options.h"
#include "game/ai/pinball_trial.h"
#include "game/pinball/pinball.h"

namespace carom {
namespace {

constexpr double least_pull = 0.46;
constexpr double pull_step = 0.03;
constexpr std::size_t pulls = 19;
constexpr std::uint64_t ticks_for_a_pull = 12;  // that it takes to think of one
constexpr double launch_time = 5.0;             // s that it looks ahead

double pull_of(std::size_t i) {
    return std::min(1.0, least_pull + pull_step * static_cast<double>(i));
}

}  // namespace

std::optional<double> PinballPlunge::think(const PinballSight& sight, const Scene& scene,
                                           const World& world, const PinballState& state,
                                           const SolverSettings& settings) {
    if (chosen_ || world.tick() % ticks_for_a_pull != 0) return chosen_;
    if (gains_.size() < pulls) {
        PinballTrial trial{world, state};
        pull_plunger(scene, trial.world, trial.state, pull_of(gains_.size()), true);
        Solver solver(settings);
        gains_.push_back(play_ahead(sight, scene, solver, std::move(trial), {},
                                    pinball_ticks(world, launch_time), false)
                             .gain);
        return chosen_;
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < pulls; ++i)
        if (value_around(gains_, i, 1) > value_around(gains_, best, 1)) best = i;
    chosen_ = pull_of(best);
    return chosen_;
}

}  // namespace carom
