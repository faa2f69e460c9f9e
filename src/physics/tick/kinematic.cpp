#include "physics/tick/kinematic.h"

#include <algorithm>

#include "geometry/closest.h"
#include "physics/broad_phase/cell_frame.h"

namespace carom {

void list_kinematic_edges(const World& world, std::vector<HeldEdge>& edges) {
    edges.clear();
    for (std::uint32_t h = 0; h < world.held_capsules().size(); ++h)
        if (const auto index = index_of(world, world.held_capsules()[h].id))
            edges.push_back({.capsule = static_cast<std::uint32_t>(*index),
                             .held = h,
                             .is_driven = world.held_capsules()[h].is_driven});
}

void aim(HeldEdge& edge, const World& world, double per_second) {
    const HeldCapsule& held = world.held_capsules()[edge.held];
    const Capsule& shape = world.capsules().shape[edge.capsule];
    edge.start_velocity = (held.start_target - shape.start) * per_second;
    edge.end_velocity = (held.end_target - shape.end) * per_second;
}

HeldEdge* find_edge(std::span<HeldEdge> edges, std::uint32_t capsule) {
    for (HeldEdge& edge : edges)
        if (edge.capsule == capsule) return &edge;
    return nullptr;
}

const HeldEdge* find_edge(std::span<const HeldEdge> edges, std::uint32_t capsule) {
    for (const HeldEdge& edge : edges)
        if (edge.capsule == capsule) return &edge;
    return nullptr;
}

Capsule shape_at(const HeldEdge& edge, const World& world, double now) {
    Capsule shape = world.capsules().shape[edge.capsule];
    const double moved = (edge.is_stopped() ? std::min(now, edge.stopped_at) : now) * edge.share;
    shape.start += edge.start_velocity * moved;
    shape.end += edge.end_velocity * moved;
    return shape;
}

Vec2 surface_velocity(const HeldEdge& edge, const Capsule& shape, Vec2 point) {
    if (edge.is_stopped()) return {};
    const double place = closest_parameter(shape.start, shape.end, point);
    return (edge.start_velocity + (edge.end_velocity - edge.start_velocity) * place) * edge.share;
}

bool has_crossed(const Capsule& was, const Capsule& is, Vec2 from, Vec2 to) {
    const double first = cross(was.end - was.start, from - was.start);
    const double last = cross(is.end - is.start, to - is.start);
    if (!(first * last < 0.0)) return false;
    const auto is_beside = [](const Capsule& edge, Vec2 place) {
        const double at = closest_parameter(edge.start, edge.end, place);
        return at > 0.0 && at < 1.0;
    };
    return is_beside(was, from) && is_beside(is, to);
}

Vec2 displacement_to_target(const World& world, const HeldBall& held, Vec2 position) {
    const Vec2 to_target = held.target - position;
    return world.model().wrap ? nearest_image(to_target, size(*world.model().wrap)) : to_target;
}

void make_held_balls_immovable(const World& world, std::vector<double>& inverse_mass) {
    for (const HeldBall& held : world.held_balls())
        if (const auto index = index_of(world, held.id)) inverse_mass[*index] = 0.0;
}

}  // namespace carom
