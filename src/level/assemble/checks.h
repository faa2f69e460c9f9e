#pragma once

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"

/// Checks of the physics: starts and values that no author can have intended.
namespace carom {

/// Reports as errors: balls that overlap each other or an edge at the start, unless they do not
/// collide or the level says `use overlap`; balls outside a torus, or too large for it; spawns
/// outside the world or inside an edge. Each ball is reported once. Bounded work: gives up with a
/// warning after 50 million pairs.
void check_start(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                 Context& context);

/// By how much two balls start inside one another; at most 0 where that is rounding, or nothing.
double overlap_at_start(const Disc& disc, const Disc& other);
/// The error that `later` starts inside `earlier`.
void report_ball_inside_ball(const Origin& later, const Origin& earlier, double depth,
                             Context& context);

/// The overlaps of the balls that a level states, found before anything is made of these. Reports
/// the first of them. Of a million balls it needs 8 MB, and `check_start` 200 more. Gives up where
/// balls are crowded or of very different sizes; what it does not find, `check_start` does.
void check_crowd(const ResolvedNames& names, Context& context);

/// Reports an error for each value that needs a term (`use spin`, `use cloth`) that the level
/// lacks.
void check_terms(Context& context);

/// Reports an error if doubles are too coarse at the place of a ball or of an emitter: their
/// spacing exceeds 1/64 of the ball's radius. Warns if its motion in a tick is lost in rounding.
/// One report for the level. `rate` is in ticks a second.
void check_precision(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                     double rate, Context& context);

/// Warns of gaps between edges that are too narrow for the smallest ball. A level without balls has
/// no such gaps, and edges that move are left out. Bounded work: gives up with a warning after 4
/// million pairs.
void check_gaps(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                Context& context);

/// Warns of a flipper whose upper face at rest is higher than the edge that leads to its pivot by
/// more than a tenth of a ball's radius: a ball that rolls down would jump over the flipper.
void check_flippers(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                    Context& context);

}  // namespace carom
