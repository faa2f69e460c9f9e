#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "level/scene/scene.h"

/// How far two worlds that began alike have come apart.
namespace carom {

/// Where all balls are, at one instant.
struct Positions {
    std::vector<BallId> id;  ///< ascending
    std::vector<Vec2> position;
};
Positions positions_of(const World& world);

/// Over the balls that are in both. Lengths; infinite where a position is not finite.
struct Difference {
    double rms = 0.0;  ///< root of the mean square distance of a ball from its twin
    double max = 0.0;
    std::optional<BallId> farthest;  ///< whose distance is `max`; none: it is 0
    std::size_t unpaired = 0;        ///< balls that are in one of the two only
};

/// `torus`: the size of the wrapped world, where it is one; the nearest images count.
Difference difference(const Positions& a, const Positions& b, const std::optional<Vec2>& torus);
Difference difference(const World& a, const World& b);

/// The size of the torus, where the world is one.
std::optional<Vec2> torus_of(const World& world);

/// The mean radius of the balls at the start and of those that emitters will make: the length that
/// errors are told in. 1 where there are none.
double mean_radius(const World& world);

}  // namespace carom
