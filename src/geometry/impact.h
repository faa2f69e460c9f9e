#pragma once

#include <algorithm>
#include <optional>

#include "geometry/shapes.h"

/// First impacts (times of impact) of bodies on straight paths.
namespace carom {

/// A time of impact in s, and the unit normal of the contact, from the other body to the disc.
struct Impact {
    double time = 0.0;
    Vec2 normal;
};

/// A cheap rejection test: true if a disc has no impact with a resting convex body within `horizon`
/// seconds. `offset` points from the nearest point of the body to the centre of the disc, `reach`
/// is the sum of the radii, and `velocity` is constant. False: there may or may not be an impact.
/// Cost: a few multiplications, no root and no division.
inline bool stays_apart(Vec2 offset, Vec2 velocity, double reach, double horizon) {
    // Since the body is convex, distance^2 at t >= offset^2 + 2 offset.velocity t. The factors
    // cover rounding, unless walls or paths are thousands of times as long as the reach. There, an
    // impact at 1e-8 rad at the very end of the horizon may be missed.
    const double away = length_squared(offset) * (1.0 - 1e-12);
    const double change = 2.0 * dot(offset, velocity) * horizon;
    return away + std::min(change, 0.0) > reach * reach * (1.0 + 1e-12);
}

/// First impact of `disc`, moving at constant `velocity`, with a resting `other`.
///
/// Units: those of the level (length, length/s, s). Looks no further than `horizon` seconds ahead.
/// Only approach counts: a disc that moves away from the other, slides along it or merely grazes it
/// has no impact. So an impact that has been resolved is never found again.
///
/// Degenerate cases, each of them a test:
///   touching or overlapping, and approaching   impact at time 0
///   touching or overlapping, not approaching   none
///   velocity zero                              none
///   same centre                                none: any motion separates them
///
/// Pre: all inputs finite, radii >= 0, horizon >= 0.
std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Disc& other,
                                   double horizon);

/// First impact of a moving disc with a resting capsule; units, approach and preconditions are
/// those of two discs. The distance from a capsule is convex along a straight path, so a disc that
/// moves away from it never hits it again.
///
///   start == end                               the capsule is a disc
///   centre of the disc on the spine            none: any motion separates them
std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   double horizon);

/// How an edge turns about a hinge.
struct HingeTurn {
    Vec2 pivot;
    double rate = 0.0;  ///< rad/s, counter-clockwise
};

/// First impact of a moving disc with a capsule that turns about a hinge at a constant rate,
/// exactly on its arc. `normal` is the normal at the impact. Conservative advancement by the
/// acceleration of the disc as seen from the capsule, so no impact is missed that is deeper than
/// rounding.
std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   const HingeTurn& turn, double horizon);

/// The capsule `time` seconds later.
Capsule turned(const Capsule& capsule, const HingeTurn& turn, double time);

/// First impact of a moving disc with a capsule whose ends have constant velocities. `normal` is
/// the normal at the impact. Where both ends have the same velocity this is the closed form of the
/// relative motion. Else: conservative advancement with a minimum step, then bisection to 1e-12 of
/// the sizes. The minimum step is 1e-4 of the horizon, and no longer than the disc needs for a
/// hundredth of the sum of the radii. So only a contact that is at most 2e-5 of that deep may be
/// missed, and it costs at most fastest relative speed * horizon / (a hundredth of that) steps.
std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   Vec2 start_velocity, Vec2 end_velocity, double horizon);

}  // namespace carom
