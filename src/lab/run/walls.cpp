#include "lab/run/walls.h"

#include <algorithm>

namespace carom {
namespace {

bool is_moved(const World& world, CapsuleId id) {
    return is_held(world, id) ||
           std::ranges::find(world.flippers(), id, &Flipper::capsule) != world.flippers().end() ||
           moves_by_itself(world, id);
}

}  // namespace

bool is_wall(const World& world, std::size_t edge, ClassIndex kind) {
    const Capsules& edges = world.capsules();
    return (!world.model().one_way || edges.side[edge] == Side::both) &&
           (!world.model().filtered || kind_meets_material(world, kind, edges.material[edge])) &&
           !is_moved(world, edges.id[edge]);
}

double distance_to_segment(Vec2 point, const Capsule& edge) {
    const Vec2 span = edge.end - edge.start;
    const double whole = length_squared(span);
    const double share =
        whole > 0.0 ? std::clamp(dot(point - edge.start, span) / whole, 0.0, 1.0) : 0.0;
    return length(point - edge.start - span * share);
}

}  // namespace carom
