#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/ai/pinball_sight.h"
#include "game/ai/pinball_trial.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// What a player of pinball can do about a ball that comes down, each tried ahead.
namespace carom {

constexpr double pinball_flip_time = 0.12;  ///< seconds that a flipper stays up for a flip
constexpr double pinball_reaction = 0.09;   ///< seconds to the earliest press after a decision

/// The nearest number of ticks.
std::uint64_t pinball_ticks(const World& world, double seconds);

/// A choice that has been tried: these presses, then `foreseen`.
struct PinballOption {
    std::vector<TimedPress> presses;
    Foreseen foreseen;
};

/// Everything that the button can do soon: first nothing; then for each of six moments two options,
/// to change the flipper's position for good, and to change it for a flip.
std::vector<PinballOption> ways_to_meet(const PinballSight& sight, const Scene& scene,
                                        const SolverSettings& settings, PinballTrial trial,
                                        Button button);

/// The nudge after which the balls are safest, at the best of three moments soon. A nudge comes
/// early or late, so the moments around it count too. None: the table has no nudge.
std::optional<PinballOption> best_nudge(const PinballSight& sight, const Scene& scene,
                                        const SolverSettings& settings, const PinballTrial& trial);

/// A press comes early or late, so a moment is worth what the moments around it are worth, each by
/// how likely it is to become that one: `reach` is the largest error, in moments.
double value_around(const std::vector<double>& values, std::size_t moment, int reach);

}  // namespace carom
