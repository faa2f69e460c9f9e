#pragma once

#include <span>
#include <vector>

#include "physics/discrete/kinematics.h"
#include "physics/discrete/step.h"

namespace carom {

/// Changes the velocities of bodies that overlapped, in the solvers `discrete` and `substep`: each
/// of the `pairs` that approaches bounces, with friction, in their order. Appends the exchanges to
/// `contacts`, at `time` (s since the start of the simulation).
///
/// A held edge acts only along its surface (friction), since balls in its way are pushed out; a
/// driven edge throws as well.
void bounce_overlapping(World& world, Terms terms, const OverlapKinematics& kinematics,
                        std::span<const OverlapPair> pairs, double time,
                        std::vector<Contact>& contacts);

}  // namespace carom
