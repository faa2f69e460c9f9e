#pragma once

#include <cstddef>
#include <optional>

#include "physics/tick/solver_settings.h"
#include "physics/world/world.h"

namespace carom {

/// What a solver promises; an absent value is no promise. `discrete` and `substep` promise nothing:
/// docs/accuracy.md measures their errors.
struct Promise {
    std::optional<double> energy;  ///< largest gain, as a share of the largest energy in play
    /// The energy in play is kinetic and potential, from the lowest ball at the start; else it is
    /// kinetic.
    bool counts_heights = false;
    /// The largest gain in ticks that begin with dense clusters, which `contact` steps
    /// (physics/event/hybrid_step.h).
    double energy_of_clustered = 0.0;
    std::optional<double> overlap;  ///< deepest, as a share of the smaller radius
    /// Deepest overlap of a ball that `contact` steps, as in the cluster of a hybrid step
    /// (physics/event/hybrid_step.h); 0 where it never does.
    double overlap_of_clustered = 0.0;
    /// A pair that starts inside one another has separated once it overlaps by no more than this
    /// share of the smaller radius. Until then a ball that turns back may go as deep as it was.
    double parted = 1e-3;
    /// It lifts overlapping bodies apart, which may add the work done against gravity. What
    /// `contact` steps in a dense cluster is always lifted so.
    bool lifts_overlaps = false;
    /// How far gravity may move a ball in a tick, in radii. While there are smaller balls, which a
    /// run notes (run_record.h), all that is promised is finite numbers.
    std::optional<double> most_fall;
    bool keeps_sides = false;  ///< no ball passes through an edge or out of an outline
    bool moves = false;        ///< a ball with a velocity does not stay where it was
    bool iterates = false;     ///< but a pressed ball may, for what it is pressed on (time_check.h)
};
Promise promise_of(SolverKind solver);
/// How many balls are too small for the promise.
std::size_t count_too_small(const Promise& promise, const World& world);

}  // namespace carom
