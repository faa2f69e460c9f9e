#pragma once

#include "physics/broad_phase/cell_frame.h"

namespace carom {

/// The shortest displacement in a world that is `offset`, or on a torus equivalent to it. `offset`
/// leads from any image of a place to any image of another one.
inline Vec2 nearest_image(const World& world, Vec2 offset) {
    return world.model().wrap ? nearest_image(offset, size(*world.model().wrap)) : offset;
}

}  // namespace carom
