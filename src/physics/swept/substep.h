#pragma once

#include "physics/laws/free_motion.h"
#include "physics/world/terms.h"

/// What the parts of the solver `swept` share besides the world: the constants of a substep. A
/// plain record.
namespace carom {

struct SweptSubstep {
    double duration = 0.0;    ///< s
    double start_time = 0.0;  ///< s since the start of the simulation
    Terms terms;
    Flight flight;  ///< over the substep
    Vec2 gravity;
    Vec2 torus;               ///< width and height; 0 on a plane
    double rest_speed = 0.0;  ///< a slower approach does not bounce, length/s
    /// Nothing but friction takes energy: a ball that is pressed too often does not come to rest,
    /// but time stands still for it.
    bool keeps_energy = false;
    /// Nothing but the balls themselves can lift them: there is gravity, and no hand or mover.
    bool counts_lifts = false;
};

/// The constants for a substep of `duration` s.
SweptSubstep swept_substep(const World& world, double duration);

}  // namespace carom
