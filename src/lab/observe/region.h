#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

namespace carom {

/// The region in which the centres of balls of the mean radius may be: the torus, or the inside of
/// the level's closed edge or box. Obstacles inside it (pegs, other edges) are not subtracted.
struct Region {
    double area = 0.0;  ///< length^2, > 0
    /// Its sides, where it is the torus or an upright rectangle.
    std::optional<Vec2> sides;
    bool is_torus = false;
};

/// The region of the present world. None without `use wrap` unless the level has exactly one closed
/// edge or box and every ball is inside; and where the balls are too large for it. An edge offset
/// inwards by the radii of edge and ball may vanish where corners are close: then the area is too
/// small by what the offsets cover twice.
std::optional<Region> region_of(const Scene& scene, const World& world);

/// Whether the point is inside the closed line of these spines, by the even-odd rule. Their radii
/// do not count.
bool is_inside(std::span<const Capsule> spines, Vec2 point);

}  // namespace carom
