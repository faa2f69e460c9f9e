#include "physics/broad_phase/neighbour_list.h"

#include <algorithm>
#include <cmath>

namespace carom {

void NeighbourList::build(const World& world, double margin) {
    const Balls& balls = world.balls();
    margin_ = margin;
    furthest_ = 0.0;
    edge_margin_ = {.least = margin, .share = 0.25};
    reference_.clear();
    if (margin > 0.0) {
        reference_ = balls.position;
        scene_.note(world);
    }
    build_around(world, balls.position, balls.radius, false);
}

void NeighbourList::build(const World& world, std::span<const Vec2> centers,
                          std::span<const double> radii) {
    margin_ = 0.0;
    edge_margin_ = {};
    build_around(world, centers, radii, EdgeMap::suits(world));
}

void NeighbourList::build_around(const World& world, std::span<const Vec2> centers,
                                 std::span<const double> radii, bool uses_map) {
    torus_ = world.model().wrap ? size(*world.model().wrap) : Vec2{};
    grid_.build(centers, radii, margin_, world.model().wrap);
    balls_ = centers.size();
    pairs_.clear();
    if (world.model().ball_ball)
        grid_.for_each_pair([&](std::uint32_t a, std::uint32_t b) {
            pairs_.push_back({std::min(a, b), std::max(a, b)});
        });
    adjacency_.clear();
    near_edges_.find(world, grid_, centers, radii, edge_margin_, uses_map);
}

// The square of how far a ball that is now at `position` is from its reference position.
double NeighbourList::squared_displacement(std::uint32_t ball, Vec2 position) const {
    Vec2 displacement = position - reference_[ball];
    if (torus_.x > 0.0) displacement = nearest_image(displacement, torus_);
    return length_squared(displacement);
}

bool NeighbourList::is_valid_for(std::uint32_t ball, Vec2 position) const {
    return margin_ > 0.0 && squared_displacement(ball, position) <= room();
}

bool NeighbourList::note_place(std::uint32_t ball, Vec2 position) {
    if (!(margin_ > 0.0)) return false;
    const double square = squared_displacement(ball, position);
    furthest_ = std::max(furthest_, square);
    return square <= room();
}

void NeighbourList::Scene::note(const World& world) {
    radius = world.balls().radius;
    shapes = world.capsules().shape;
    capsules = world.stamps().capsules;
    held.clear();
    for (const HeldCapsule& capsule : world.held_capsules())
        held.push_back(capsule.id);
    has_ball_pairs = world.model().ball_ball;
    has_edge_pairs = world.model().ball_edge;
}

// Edges that were held and still are may have moved.
bool NeighbourList::Scene::is_of(const World& world) const {
    const Capsules& now = world.capsules();
    if (radius != world.balls().radius) return false;
    if (has_ball_pairs != world.model().ball_ball || has_edge_pairs != world.model().ball_edge)
        return false;
    if (shapes.size() != now.size()) return false;
    if (!std::ranges::equal(held, world.held_capsules(), {}, {}, &HeldCapsule::id)) return false;
    if (capsules == world.stamps().capsules) return true;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (shapes[i] != now.shape[i] && !is_held(world, now.id[i])) return false;
    return true;
}

bool NeighbourList::is_valid(const World& world) {
    const Balls& balls = world.balls();
    if (!(margin_ > 0.0) || !scene_.is_of(world)) return false;
    if (torus_ != (world.model().wrap ? size(*world.model().wrap) : Vec2{})) return false;
    furthest_ = 0.0;
    for (std::uint32_t i = 0; i < balls.size(); ++i)
        if (!note_place(i, balls.position[i])) return false;
    return true;
}

bool NeighbourList::is_valid_after(double displacement) {
    const double all = std::sqrt(furthest_) + displacement;
    furthest_ = all * all;
    return margin_ > 0.0 && furthest_ <= room();
}

}  // namespace carom
