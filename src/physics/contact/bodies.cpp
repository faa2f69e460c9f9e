#include "physics/contact/bodies.h"
#include "physics/contact/contact_memory.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/tolerances.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// Overlaps are pushed apart only in a scene that loses energy: in an elastic scene that would add
// energy.
ContactSoftness softness_of(const World& world, double duration) {
    if (!world.model().inelastic) return {.push = 0.0, .mass_share = 1.0, .impulse_share = 0.0};
    constexpr double turn = 6.283185307179586 * contact_tolerance::stiffness;  // rad a substep
    constexpr double first = 2.0 * contact_tolerance::damping + turn;
    constexpr double second = turn * first;
    return {.push = turn / first / duration,
            .mass_share = second / (1.0 + second),
            .impulse_share = 1.0 / (1.0 + second),
            .spring = turn * turn / (duration * duration)};
}

}  // namespace

ContactSubstep contact_substep(const World& world, int count, bool is_strict) {
    ContactSubstep step;
    step.is_strict = is_strict;
    step.duration = world.tick_length() / count;
    step.flight = flight_over(world.model().drag, step.duration);
    step.gravity = world.model().gravity.value_or(Vec2{});
    step.drag = world.model().drag;
    step.wraps = world.model().wrap.has_value();
    step.torus = step.wraps ? size(*world.model().wrap) : Vec2{};
    step.fall = length(step.gravity) * step.duration * step.duration;
    step.rest_speed = contact_tolerance::rest_speed_factor * length(step.gravity) * step.duration;
    step.softness = softness_of(world, step.duration);
    step.spins = world.model().spin.has_value();
    if (step.spins) {
        step.spin_ease = 1.0 / *world.model().spin;
        step.spin_share = 1.0 / step.spin_ease;
        step.friction_mass = 1.0 / (1.0 + step.spin_ease);
    }
    return step;
}

void ContactBodies::load(const World& world) {
    const Balls& balls = world.balls();
    const ReferencePositions& stored = contact_memory(world).reference;
    const std::size_t count = balls.size();
    fixed = static_cast<std::uint32_t>(count);
    ball = stored.order;
    position.resize(count);
    reference.resize(count);
    radius.resize(count);
    skin.resize(count);
    start_velocity.resize(count + 1);
    displacement.resize(count + 1);
    body.resize(count + 1);
    smallest_radius = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < fixed; ++i) {
        const std::uint32_t index = ball[i];
        position[i] = balls.position[index];
        radius[i] = balls.radius[index];
        smallest_radius = std::min(smallest_radius, radius[i]);
        reference[i] = stored.position[index];
        skin[i] = stored.skin[index];
        body[i] = {balls.velocity[index], 0.0, balls.inverse_mass[index]};
        if (world.model().spin) body[i].surface_speed = balls.spin[index] * balls.radius[index];
    }
    start_velocity[fixed] = displacement[fixed] = {};
    body[fixed] = {};
}

void ContactBodies::reload(const World& world) {
    const Balls& balls = world.balls();
    for (std::uint32_t i = 0; i < fixed; ++i) {
        const std::uint32_t index = ball[i];
        position[i] = balls.position[index];
        body[i].velocity = balls.velocity[index];
        if (world.model().spin) body[i].surface_speed = balls.spin[index] * balls.radius[index];
    }
}

void ContactBodies::store(World& world) const {
    Balls& balls = SolverAccess(world).balls();
    for (std::uint32_t i = 0; i < fixed; ++i) {
        const std::uint32_t index = ball[i];
        balls.position[index] =
            world.model().wrap ? wrapped(position[i], *world.model().wrap) : position[i];
        balls.velocity[index] = body[i].velocity;
        if (world.model().spin) balls.spin[index] = body[i].surface_speed / balls.radius[index];
    }
}

void ContactBodies::integrate_velocities(const World& world, const ContactSubstep& step) {
    const Vec2 fall = step.gravity * step.flight.velocity_per_gravity;
    const std::optional<double> limit = world.model().speed_limit;
    start_surface_speed.clear();
    if (step.spins)
        for (std::uint32_t i = 0; i < fixed; ++i)
            start_surface_speed.push_back(body[i].surface_speed);
    for (std::uint32_t i = 0; i < fixed; ++i) {
        Vec2 velocity = body[i].velocity;
        if (limit) velocity = limited(velocity, *limit);
        start_velocity[i] = velocity;
        body[i].velocity = velocity * step.flight.decay + fall;
    }
}

double overlap_bound(const ContactPair& pair) {
    return contact_tolerance::overlap_limit * pair.radius;
}

bool is_embedded(const ContactBodies& bodies, const ContactPair& pair) {
    return bodies.is_ball(pair.b) &&
           -pair.separation > contact_tolerance::embedded * overlap_bound(pair);
}

Contact contact_of(const ContactBodies& bodies, const ContactPair& pair, double time,
                   double impulse) {
    const bool on_edge = pair.is_on_edge();
    return {.time = time,
            .kind = on_edge ? ContactKind::ball_edge : ContactKind::ball_ball,
            .a = bodies.ball[pair.a],
            .b = on_edge ? pair.edge : bodies.ball[pair.b],
            .point = bodies.position[pair.a] - pair.normal * bodies.radius[pair.a],
            .normal = pair.normal,
            .approach = impulse / pair.mass,
            .impulse = impulse};
}

double soft_bound(const ContactSubstep& step, const ContactPair& pair) {
    const double bound = overlap_bound(pair);
    const double depth = -std::min(pair.separation, 0.0);
    if (step.trusts_constraints()) return std::max(bound, depth);
    const double room = contact_tolerance::strict_overlap * pair.radius - depth;
    return std::max(depth, std::min(bound, depth + contact_tolerance::strict_share * room));
}

}  // namespace carom
