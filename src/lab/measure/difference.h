#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "level/scene/scene.h"

/// Measures how far two worlds with one start are apart.
namespace carom {

/// The positions of all balls at one instant.
struct Positions {
    std::vector<BallId> id;  ///< ascending
    std::vector<Vec2> position;
};
Positions positions_of(const World& world);

/// Distances of the balls that exist in both worlds; infinite if a position is not finite.
struct Difference {
    double rms = 0.0;  ///< root mean square distance of a ball from its counterpart
    double max = 0.0;
    std::optional<BallId> farthest;  ///< the ball with the distance `max`; none if that is 0
    std::size_t unpaired = 0;        ///< balls that only one of the two worlds has
};

/// `torus`: the size of a wrapped world, in which distances are to the nearest image.
Difference difference(const Positions& a, const Positions& b, const std::optional<Vec2>& torus);
Difference difference(const World& a, const World& b);

/// The size of the torus, if the world is one.
std::optional<Vec2> torus_of(const World& world);

/// The mean radius of the balls at the start and of those that emitters will add: the unit of
/// length of reported errors. 1 without balls.
double mean_radius(const World& world);

}  // namespace carom
