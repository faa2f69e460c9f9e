#pragma once

#include <algorithm>
#include <optional>

#include "geometry/shapes.h"

/// First impacts along straight paths.
namespace carom {

/// When, and the unit normal of the contact, from the other body to the disc.
struct Impact {
    double time = 0.0;
    Vec2 normal;
};

/// Whether a disc certainly has no impact within `horizon` seconds with a resting body whose
/// nearest point lies at -`offset` from its centre now: `reach` is the sum of the radii, `velocity`
/// constant. Cheap: no root, no division. False says nothing.
inline bool stays_apart(Vec2 offset, Vec2 velocity, double reach, double horizon) {
    // distance^2 at t >= offset^2 + 2 offset.velocity t, since the body is convex. The small
    // numbers are above rounding, but for walls and paths some thousand times as long as the reach:
    // of those, an impact at 1e-8 rad at the very end of the horizon may be passed over.
    const double away = length_squared(offset) * (1.0 - 1e-12);
    const double change = 2.0 * dot(offset, velocity) * horizon;
    return away + std::min(change, 0.0) > reach * reach * (1.0 + 1e-12);
}

/// First impact of `disc`, moving at constant `velocity`, with a resting `other`.
///
/// Units: those of the level (length, length/s, s). Looks no further than `horizon` seconds ahead.
/// Only approach counts: a disc that parts from the other, slides along it or merely grazes it has
/// no impact, so a bounce that has been resolved is never found twice.
///
/// Degenerate cases, each of them a test:
///   touching or overlapping, and approaching   impact at time 0
///   touching or overlapping, not approaching   none
///   velocity zero                              none
///   same centre                                none: every way leads apart
///
/// Pre: all inputs finite, radii >= 0, horizon >= 0.
std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Disc& other,
                                   double horizon);

/// The same for a resting capsule. The distance from a capsule is convex along a straight path, so
/// a disc that parts from it now never meets it again.
///
///   start == end                               the capsule is a disc
///   centre of the disc on the spine            none: every way leads apart
std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   double horizon);

/// The same for a capsule whose ends move at constant velocities of their own. Found by
/// conservative advancement with a least step of 1e-4 of the horizon, refined by bisection to 1e-12
/// of the sizes; a touch that is shorter than that step may be passed over. `normal` as at the
/// impact.
std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   Vec2 start_velocity, Vec2 end_velocity, double horizon);

}  // namespace carom
