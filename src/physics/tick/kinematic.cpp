#include "physics/tick/kinematic.h"

#include <algorithm>
#include <limits>

#include "geometry/closest.h"
#include "physics/broad_phase/nearest_image.h"
#include "physics/world/solver_access.h"

namespace carom {

void list_kinematic_edges(const World& world, std::vector<HeldEdge>& edges) {
    edges.clear();
    for (std::uint32_t h = 0; h < world.held_capsules().size(); ++h)
        if (const auto index = index_of(world, world.held_capsules()[h].id))
            edges.push_back({.capsule = static_cast<std::uint32_t>(*index),
                             .held = h,
                             .is_driven = world.held_capsules()[h].is_driven});
    for (HeldEdge& edge : edges)
        if (const auto seesaw = seesaw_of(world, world.held_capsules()[edge.held].id)) {
            edge.is_seesaw = true;
            edge.seesaw = world.seesaws()[*seesaw];
            if (is_standing(edge.seesaw)) edge.stop(0.0);
        }
}

Seesaw HeldEdge::seesaw_at(double now) const {
    Seesaw turned = seesaw;
    turn_on(turned, std::max(0.0, (is_stopped() ? std::min(now, stopped_at) : now) - since));
    return turned;
}

double HeldEdge::time_of_stop() const {
    return is_stopped() ? std::numeric_limits<double>::infinity() : since + time_to_stop(seesaw);
}

double first_stop(std::span<const HeldEdge> edges) {
    double first = std::numeric_limits<double>::infinity();
    for (const HeldEdge& edge : edges)
        if (edge.is_seesaw) first = std::min(first, edge.time_of_stop());
    return first;
}

void bounce_at_stops(std::span<HeldEdge> edges, double now) {
    for (HeldEdge& edge : edges) {
        if (!edge.is_seesaw || edge.time_of_stop() > now) continue;
        Seesaw bounced = edge.seesaw;
        bounce_at_stop(bounced);
        edge.turn(bounced, now);
        if (is_standing(bounced)) edge.stop(now);
    }
}

void finish(const HeldEdge& edge, World& world, double duration) {
    SolverAccess(world).capsules().shape[edge.capsule] = shape_at(edge, world, duration);
    if (!edge.is_seesaw) return;
    const Seesaw turned = edge.seesaw_at(duration);
    world.edit_seesaws()[*seesaw_of(world, turned.capsule)] = turned;
}

void aim(HeldEdge& edge, const World& world, double per_second) {
    if (edge.is_seesaw) return;
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
    if (edge.is_seesaw) {
        const Seesaw turned = edge.seesaw_at(now);
        return seesaw_shape(turned, turned.angle);
    }
    Capsule shape = world.capsules().shape[edge.capsule];
    const double moved = (edge.is_stopped() ? std::min(now, edge.stopped_at) : now) * edge.share;
    shape.start += edge.start_velocity * moved;
    shape.end += edge.end_velocity * moved;
    return shape;
}

Vec2 surface_velocity(const HeldEdge& edge, const Capsule& shape, Vec2 point) {
    if (edge.is_stopped()) return {};
    if (edge.is_seesaw)
        return perpendicular(closest_point(shape.start, shape.end, point) - edge.seesaw.pivot) *
               edge.seesaw.rate;
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
    return nearest_image(world, held.target - position);
}

void make_held_balls_immovable(const World& world, std::vector<double>& inverse_mass) {
    for (const HeldBall& held : world.held_balls())
        if (const auto index = index_of(world, held.id)) inverse_mass[*index] = 0.0;
}

}  // namespace carom
