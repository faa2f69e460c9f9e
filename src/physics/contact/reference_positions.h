#pragma once

#include "physics/contact/bodies.h"

/// Verlet reference positions of the solver `contact` (ContactMemory::reference): where the balls
/// were when their pairs were found. While each ball stays within its skin of there, these pairs
/// are all that could meet. The reference positions belong to the world, since pairs are solved in
/// an order that depends on them.
namespace carom {

/// Whether the result is the same whenever pairs are found anew: in a scene in which nothing is
/// ever a constraint, so pairs need no order, and which has neither a torus nor spin, which would
/// be rounded when bodies are loaded.
bool is_pair_order_irrelevant(const World& world);

/// New reference positions for all balls, where they are now. A skin holds what the ball needs for
/// the tick at its speed, but at least what it needs if it is hit, and for a very fast ball only
/// what it needs for a substep.
void set_reference_positions(World& world, const ContactSubstep& step);

/// Whether those of an earlier tick will do, at least for the next substep. Never on a torus, where
/// balls leave them behind at the seams, nor while something is held, whose pairs change each tick.
bool has_valid_reference_positions(const World& world, const ContactSubstep& step);

/// Whether no ball can leave its skin in the next substep.
bool are_within_skins(const ContactBodies& bodies, const ContactSubstep& step);

}  // namespace carom
