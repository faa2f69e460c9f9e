#pragma once

#include <optional>

#include "geometry/vec2.h"
#include "physics/world/world.h"

/// The lines that help to aim a ball, by geometry alone: what the struck ball would meet on a
/// straight line, and which ways the two would part. What really happens is game/forecast.h.
namespace carom {

struct AimLine {
    Vec2 from;                     ///< the middle of the ball that is struck
    Vec2 to;                       ///< where it is when it meets something, or far away
    std::optional<BallId> object;  ///< the ball that it meets first; none: an edge, or nothing
    /// With an object: the unit vector of its way, the line of centres.
    Vec2 object_way;
    /// With an object: the unit vector of the way of a ball that slides, at a right angle to it; 0
    /// where the ball is met full.
    Vec2 tangent;
    /// With an object: cosine of the cut angle, 1 when the ball is met full.
    double cut_cosine = 0.0;
};

/// None when there is no such ball, or the direction is 0.
std::optional<AimLine> aim_line(const World& world, BallId ball, Vec2 direction);

/// Where the middle of a ball of this radius must be when it meets `object`, for the object to go
/// towards `target`. Pre: object and target differ.
Vec2 ghost_place(Vec2 object, double object_radius, double radius, Vec2 target);

}  // namespace carom
