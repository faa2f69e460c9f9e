#include <algorithm>

#include "geometry/closest.h"
#include "physics/contact/path.h"
#include "physics/contact/solver.h"
#include "physics/laws/bounce.h"

// What an impact within a substep of the solver `contact` does to the two that meet.
namespace carom {

double ContactSolver::restitution_of(const World& world, const Pair& pair, double approach) const {
    if (!world.model.lossy) return 1.0;
    if (pair.edge != NearPair::no_edge)
        return restitution_at(world.materials[world.capsules.material[pair.edge]], approach);
    return std::min(world.balls.restitution[ball_[pair.a]], world.balls.restitution[ball_[pair.b]]);
}

void ContactSolver::collide(World& world, const Event& event, std::vector<Contact>& contacts) {
    Pair& pair = pairs_[event.pair];
    const std::uint32_t a = pair.a;
    const std::uint32_t b = pair.b;
    const double now = event.time;
    if (b > still_ && path_of(a).stands) {
        stop_hand(world, pair.edge, now);
        return;
    }
    const auto contact =
        b < still_ ? collide_balls(world, pair, now) : collide_edge(world, pair, now);
    if (contact) {
        pair.is_new = false;
        contacts.push_back(*contact);
        contacts.back().time += start_time_;
    }
    predict(world, a, now);
    if (b < still_) predict(world, b, now);
}

std::optional<Contact> ContactSolver::collide_balls(World& world, Pair& pair, double now) {
    const std::uint32_t a = pair.a;
    const std::uint32_t b = pair.b;
    Vec2 offset = position_at(world, a, now) - position_at(world, b, now);
    if (wraps_) offset = nearest_image(offset, torus_);
    const Vec2 normal = direction(offset, pair.normal);
    Vec2 velocity_a = velocity_at(world, a, now);
    Vec2 velocity_b = velocity_at(world, b, now);
    double rim_a = rim_at(a, now);
    double rim_b = rim_at(b, now);
    const double approach = -dot(velocity_a - velocity_b, normal);
    const double rounding = noise * (length(velocity_a) + length(velocity_b));
    const bool bounces =
        approach > std::max(rounding, resting_speed_) && !pair.settled && !is_bedded(pair);
    const bool again = pair.settled;
    pair.settled = again || !bounces;
    const double restitution = bounces ? restitution_of(world, pair, approach) : 0.0;
    Exchange done{0.0, approach};
    if (is_held_body(a))
        done = bounce_off(velocity_b, mover_[b].inverse_mass, -normal, dot(velocity_a, -normal),
                          restitution);
    else if (is_held_body(b))
        done = bounce_off(velocity_a, mover_[a].inverse_mass, normal, dot(velocity_b, normal),
                          restitution);
    else if (approach > 0.0)
        done = bounce(velocity_a, mover_[a].inverse_mass, velocity_b, mover_[b].inverse_mass,
                      normal, restitution);
    if (world.model.spin)
        rub(velocity_a, {rim_a, 1.0}, mover_[a].inverse_mass, velocity_b, {rim_b, 1.0},
            mover_[b].inverse_mass, normal, done.impulse, {pair.friction, *world.model.spin});
    take_path(world, a, now, velocity_a, rim_a);
    take_path(world, b, now, velocity_b, rim_b);
    if (is_held_body(a)) count_push(b, now);
    if (is_held_body(b)) count_push(a, now);
    if (!(approach > rounding)) {
        if (again) {
            wait_behind(a, b, -normal, now);
            wait_behind(b, a, normal, now);
        }
        return std::nullopt;
    }
    return Contact{.time = now,
                   .kind = ContactKind::ball_ball,
                   .a = ball_[a],
                   .b = ball_[b],
                   .point = path_of(b).position + normal * radius_[b],
                   .normal = normal,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

std::optional<Contact> ContactSolver::collide_edge(World& world, Pair& pair, double now) {
    const std::uint32_t a = pair.a;
    const Vec2 position = position_at(world, a, now);
    const Capsule shape = edge_at(world, pair, now);
    const Vec2 normal =
        direction(position - closest_point(shape.start, shape.end, position), pair.normal);
    const Hand* const hand = pair.b > still_ ? hand_of(pair.edge) : nullptr;
    const Vec2 surface = hand ? surface_velocity(*hand, shape, position) : Vec2{};
    const bool is_driven = hand && hand->is_driven;
    const double along_normal = dot(surface, normal);
    Vec2 velocity = velocity_at(world, a, now);
    double rim = rim_at(a, now);
    const double approach = along_normal - dot(velocity, normal);
    const double rounding = noise * (length(velocity) + length(surface));
    if (is_held_body(a)) {
        // A held ball goes no further than the edge lets it.
        pair.settled = true;
        take_path(world, a, now, velocity + normal * std::max(0.0, approach), rim);
        return std::nullopt;
    }
    const double least = std::max(rounding, along_normal > 0.0 ? 0.0 : resting_speed_);
    const bool bounces = approach > least && !pair.settled && !is_bedded(pair);
    const bool again = pair.settled;
    pair.settled = again || !bounces;
    Vec2 along = normal;
    Exchange done{0.0, approach};
    if (approach > 0.0) {
        const double restitution = bounces ? restitution_of(world, pair, approach) : 0.0;
        if (bounces && world.model.scatter)
            along = scattered_normal(world, world.balls.id[ball_[a]],
                                     world.balls.edge_contacts[ball_[a]]++, normal, velocity,
                                     restitution);
        done = bounce_off(velocity, mover_[a].inverse_mass, along, dot(surface, along), restitution,
                          is_driven);
        if (bounces && world.model.kicks)
            velocity += along * kick_at(world.materials[world.capsules.material[pair.edge]], shape,
                                        position, approach);
        if (world.model.spin)
            rub_on(velocity, {rim, 1.0}, mover_[a].inverse_mass, along, surface, done.impulse,
                   {pair.friction, *world.model.spin});
    }
    take_path(world, a, now, velocity, rim);
    if (along_normal > 0.0 && !is_driven) count_push(a, now);
    if (!(approach > rounding)) {
        if (again && !hand) wait_at(a, normal, now);
        return std::nullopt;
    }
    return Contact{.time = now,
                   .kind = ContactKind::ball_edge,
                   .a = ball_[a],
                   .b = pair.edge,
                   .point = position - normal * radius_[a],
                   .normal = along,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

}  // namespace carom
