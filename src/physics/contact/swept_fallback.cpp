#include "physics/contact/swept_fallback.h"

#include <algorithm>
#include <cmath>

#include "physics/tick/totals.h"

namespace carom {

bool is_flight_only(const World& world) {
    const Model& model = world.model();
    return !model.gravity && !model.drag && !model.speed_limit && !model.inelastic &&
           !model.cloth && world.held_balls().empty() && world.held_capsules().empty();
}

int flight_substeps(const World& world, int most) {
    if (most == 1) return 1;
    const double share = typical_travel_in_radii(world) / 0.3;
    // No ball at all, or balls of no size: not a number, or without bound.
    return share > 1.0 ? static_cast<int>(std::min(std::ceil(share), 1.0 * most)) : 1;
}

}  // namespace carom
