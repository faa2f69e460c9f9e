#pragma once

#include <optional>

#include "geometry/vec2.h"
#include "physics/world/world.h"

/// Aiming lines by geometry alone: what the struck ball would hit on a straight line, and the
/// directions in which the two balls would leave. session/forecast.h simulates what really happens.
namespace carom {

struct AimLine {
    Vec2 from;                     ///< the centre of the struck ball
    Vec2 to;                       ///< its centre at the first hit, or far away
    std::optional<BallId> object;  ///< the ball that it hits first; none: an edge, or nothing
    /// With an object: its direction, a unit vector along the line of centres.
    Vec2 object_way;
    /// With an object: the direction of a sliding cue ball, a unit vector at a right angle to the
    /// line of centres; 0 for a full hit.
    Vec2 tangent;
    /// With an object: cosine of the cut angle, 1 for a full hit.
    double cut_cosine = 0.0;
};

/// None if the ball does not exist, or the direction is 0. Cost: one pass over all bodies.
std::optional<AimLine> aim_line(const World& world, BallId ball, Vec2 direction);

/// The ghost ball: the centre of a ball of this radius at the hit that sends `object` towards
/// `target`. Pre: object and target differ.
Vec2 ghost_place(Vec2 object, double object_radius, double radius, Vec2 target);

}  // namespace carom
