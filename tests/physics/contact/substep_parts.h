#pragma once

#include "physics/contact/pairs.h"
#include "physics/contact/reference_positions.h"
#include "physics/support/scenes.h"

namespace carom {

/// What the parts of the solver `contact` share in a substep, of a world that a test makes.
struct SubstepParts {
    World world = scenes::empty();
    ContactSubstep step;
    ContactBodies bodies;
    ContactPairs pairs;

    /// Fills in the rest from the world, as a tick of four substeps begins.
    void load() {
        step = contact_substep(world, 4, false);
        set_reference_positions(world, skin_sizes(world, step));
        pairs.find(world);
        bodies.load(world);
        pairs.load(world, step, bodies, {});
    }
};

}  // namespace carom
