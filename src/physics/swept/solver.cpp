#include "physics/swept/solver.h"

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/contact/swept_fallback.h"
#include "physics/laws/bounce.h"
#include "physics/tick/emitters_and_sinks.h"
#include "physics/world/solver_access.h"

namespace carom {

void SweptSolver::tick(World& world, int substeps, std::vector<Contact>& contacts,
                       std::vector<std::uint8_t>& touched, Patience& patience) {
    const int count = substeps_needed(world, substeps);
    const double duration = world.tick_length() / count;
    const double start = world.time();
    flight_ = flight_over(world.model().drag, duration);
    duration_ = duration;
    rest_speed_ =
        world.model().gravity ? resting_approach * length(*world.model().gravity) * duration : 0.0;
    slides_first_ = world.model().cloth.has_value();
    keeps_energy_ = is_flight_only(world);
    torus_ = world.model().wrap ? size(*world.model().wrap) : Vec2{};
    inverse_mass_ = world.balls().inverse_mass;
    make_held_balls_immovable(world, inverse_mass_);
    for (int i = 0; i < count; ++i) {
        begin_paths(world, 1.0 / (count - i));
        if (!patience.lasts(world.balls().size())) return;
        move_along_paths(world, start + duration * i, contacts, touched, patience);
        if (patience.is_out()) return;
        finish_paths(world);
    }
}

void SweptSolver::begin_paths(World& world, double share_of_way) {
    const Balls& balls = world.balls();
    gravity_ = world.model().gravity.value_or(Vec2{});
    paths_.resize(balls.size());
    resting_.resize(world.model().gravity ? balls.size() : 0);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Vec2 velocity = balls.velocity[i];
        if (world.model().speed_limit) velocity = limited(velocity, *world.model().speed_limit);
        paths_[i] = Path{.position = balls.position[i], .start_velocity = velocity};
        paths_[i].velocity =
            world.model().cloth
                ? mean_velocity(world, static_cast<std::uint32_t>(i), velocity, gravity_, 0.0)
                : travel(flight_, velocity, gravity_) / duration_;
    }
    for (const HeldBall& held : world.held_balls()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        paths_[*index].velocity =
            rest_of_way(world, held, balls.position[*index]) * (share_of_way / duration_);
    }
    spin_rate_.assign(world.model().spin ? balls.size() : 0, 0.0);
    list_kinematic_edges(world, kinematic_edges_);
    for (HeldEdge& edge : kinematic_edges_)
        aim(edge, world, share_of_way / duration_);
}

void SweptSolver::finish_paths(World& world) {
    Balls& balls = SolverAccess(world).balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const auto ball = static_cast<std::uint32_t>(i);
        const Path& path = paths_[i];
        Vec2 position = position_at(ball, duration_);
        if (world.model().wrap) position = wrapped(position, *world.model().wrap);
        balls.position[i] = position;
        if (world.model().spin)
            balls.spin[i] = (path.is_frozen && !keeps_energy_) || is_held_ball(ball)
                                ? 0.0
                                : balls.spin[i] + spin_rate_[i] * (duration_ - path.time);
        if (path.is_frozen || is_held_ball(ball)) {
            balls.velocity[i] = is_held_ball(ball) ? Vec2{} : path.start_velocity;
            if (world.model().cloth) balls.roll[i] = {};
            continue;
        }
        if (world.model().cloth) {
            const auto after = on_cloth(world, ball, path.start_velocity, duration_ - path.time);
            balls.velocity[i] = Vec2(after.velocity);
            balls.roll[i] = Vec2(after.roll);
            balls.spin[i] = after.spin;
            continue;
        }
        const Flight flight =
            path.time == 0.0 ? flight_ : flight_over(world.model().drag, duration_ - path.time);
        Vec2 velocity = velocity_after(flight, path.start_velocity, gravity_on(ball));
        if (world.model().speed_limit) velocity = limited(velocity, *world.model().speed_limit);
        balls.velocity[i] = velocity;
    }
    for (const HeldEdge& edge : kinematic_edges_)
        SolverAccess(world).capsules().shape[edge.capsule] =
            carom::shape_at(edge, world, duration_);
}

Capsule SweptSolver::shape_at(const World& world, std::uint32_t capsule, double now) const {
    const HeldEdge* const edge = kinematic_edge(capsule);
    return edge ? carom::shape_at(*edge, world, now) : world.capsules().shape[capsule];
}

// All that the ball can touch from now to the end of the substep lies in this disc.
Disc SweptSolver::bounding_disc(const World& world, std::uint32_t ball, double now) const {
    const Vec2 half = paths_[ball].velocity * (0.5 * (duration_ - now));
    const Vec2 center = position_at(ball, now) + half;
    // Wider by more than rounding takes.
    constexpr double hair = 1e-14;
    const double size = std::fabs(center.x) + std::fabs(center.y);
    return {center, world.balls().radius[ball] + length(half) + hair * size};
}

Box SweptSolver::bounding_box(const World& world, std::uint32_t ball, double now) const {
    const Vec2 from = position_at(ball, now);
    const Vec2 to = from + paths_[ball].velocity * (duration_ - now);
    return grow(join({from, from}, {to, to}), world.balls().radius[ball]);
}

}  // namespace carom
