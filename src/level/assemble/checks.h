#pragma once

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"

/// Physical sense: what no author can have meant.
namespace carom {

/// Errors: balls that start inside one another or inside an edge (unless they never meet, or
/// `use overlap`), balls outside a torus, spawns outside the world or inside an edge, a torus too
/// small for its balls.
/// Each ball is told once, and each statement once for each statement that it collides with.
void check_start(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                 Context& context);

/// An error for each value that needs a term which the level does not use.
void check_terms(Context& context);

/// An error where numbers are too coarse for a ball: at its place their spacing is more than 1/64
/// of its radius. A warning where they are for its way: what it travels in a tick is lost in
/// rounding. One message for the level. `rate`: ticks a second.
void check_precision(const std::vector<StartingBall>& balls, double rate, Context& context);

/// Warnings: gaps between edges that do not touch, too narrow for the smallest ball. None where
/// there are no balls.
void check_gaps(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                Context& context);

}  // namespace carom
