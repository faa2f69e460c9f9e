#include "physics/broad_phase/edge_map.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr std::size_t edges_a_ball = 8;
constexpr double cells_an_edge = 4.0;

// The width that gives about `cells_an_edge` cells an edge.
double width_of_cells(const World& world) {
    Box whole = bounds(world.capsules().shape.front());
    for (const Capsule& shape : world.capsules().shape)
        whole = join(whole, bounds(shape));
    const Vec2 extent = size(whole);
    const auto cells = cells_an_edge * static_cast<double>(world.capsules().size());
    return std::max(std::sqrt(extent.x * extent.y / cells), std::max(extent.x, extent.y) / cells);
}

}  // namespace

bool EdgeMap::suits(const World& world) {
    return world.model().ball_edge && !world.model().wrap &&
           world.capsules().size() > edges_a_ball * world.balls().size();
}

void EdgeMap::update(const World& world) {
    if (cells_.mend(world)) return;
    middles_.clear();
    for (const Capsule& shape : world.capsules().shape)
        middles_.push_back((shape.start + shape.end) * 0.5);
    frame_ = frame_around(middles_, width_of_cells(world), cells_an_edge);
    cells_.update(world, frame_, 0.0);
    seen_.assign(world.capsules().size(), 0);
    round_ = 0;
}

}  // namespace carom
