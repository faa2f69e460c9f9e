#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/ccd/response.h"
#include "physics/laws/contact_material.h"
#include "physics/swept/solver.h"

// How the solver `swept` resolves an impact; predict.cpp finds impacts.
namespace carom {
namespace {

// What supports with the normals `first` and `second` (unit, or 0) leave of `gravity`: the nearest
// acceleration that leads into neither.
Vec2 left_by_supports(Vec2 gravity, Vec2 first, Vec2 second) {
    const auto along = [gravity](Vec2 normal) {
        return gravity - normal * std::min(0.0, dot(gravity, normal));
    };
    const Vec2 by_first = along(first);
    if (dot(by_first, second) >= 0.0) return by_first;
    const Vec2 by_second = along(second);
    if (dot(by_second, first) >= 0.0) return by_second;
    return {};
}

}  // namespace

// The velocity on the parabola where it is as high as the chord is now.
Vec2 SweptSolver::velocity_at(const World& world, std::uint32_t ball, double now) const {
    const Path& path = paths_[ball];
    if (is_held_ball(ball) || path.is_frozen) return path.velocity;
    const double since = now - path.time;
    if (world.model().cloth)
        return Vec2(on_cloth(world, ball, path.start_velocity, since).velocity);
    const Flight flight = flight_over(world.model().drag, since);
    const Vec2 gravity = gravity_on(ball);
    Vec2 velocity = velocity_after(flight, path.start_velocity, gravity);
    const double pull = length(gravity);
    if (pull > 0.0 && !world.model().drag) {
        const Vec2 down = gravity / pull;
        const double fall = dot(velocity, down);
        const double there = std::sqrt(fall * fall + pull * pull * since * (duration_ - now));
        velocity += down * ((fall < 0.0 ? -there : there) - fall);
    }
    return velocity;
}

// The velocity along the chord of the flight that starts now.
Vec2 SweptSolver::mean_velocity(const World& world, std::uint32_t ball, Vec2 velocity, Vec2 gravity,
                                double now) const {
    const double left = duration_ - now;
    if (!(left > 0.0)) return velocity;
    if (world.model().cloth) return Vec2(on_cloth(world, ball, velocity, left).position) / left;
    return travel(flight_over(world.model().drag, left), velocity, gravity) / left;
}

// From now on the ball flies from where it is, at first at `velocity`. Predictions along its old
// path become void.
void SweptSolver::redirect(const World& world, std::uint32_t ball, double now, Vec2 velocity) {
    Path& path = paths_[ball];
    path.position = position_at(ball, now);
    path.time = now;
    if (!path.is_frozen) path.start_velocity = velocity;
    path.velocity = path.is_frozen ? Vec2{}
                    : is_held_ball(ball)
                        ? velocity
                        : mean_velocity(world, ball, velocity, gravity_on(ball), now);
    const bool is_first = path.version++ == 0;
    if (is_first) ++changed_paths_;
    cells_.enter(ball, bounding_box(world, ball, now), is_first && !are_all_in_cells_);
}

// The ball leaves the impact at `velocity`.
void SweptSolver::count_impact(std::uint32_t ball, Vec2 velocity, bool resting) {
    Path& path = paths_[ball];
    if (path.is_frozen) return;
    ++path.impacts;
    if (resting) ++path.resting_impacts;
    const int most = most_resting_impacts * (slides_first_ ? 2 : 1);
    if (path.resting_impacts < most && path.impacts < most_impacts) return;
    path.is_frozen = true;
    path.is_grounded = true;
    path.start_velocity = keeps_energy_ ? velocity : Vec2{};
}

// The ball has come to rest on something immovable; `normal` points from there to the ball.
void SweptSolver::rest_on(std::uint32_t ball, Vec2 normal, const World& world) {
    if (!world.model().gravity || !(dot(normal, *world.model().gravity) < 0.0)) return;
    Path& path = paths_[ball];
    path.is_grounded = true;
    RestingContacts& contacts = resting_[ball];
    if (!path.is_resting) contacts = {};
    path.is_resting = true;
    if (dot(contacts.support, normal) < 0.999) contacts.other_support = contacts.support;
    contacts.support = normal;
    contacts.gravity = left_by_supports(gravity_, contacts.support, contacts.other_support);
    if (world.model().spin) spin_rate_[ball] = 0.0;
}

// A bounce takes the ball off what it rested on.
void SweptSolver::end_rest(std::uint32_t ball, const World& world) {
    Path& path = paths_[ball];
    path.is_resting = false;
    path.is_grounded = path.is_frozen;
    if (world.model().spin) spin_rate_[ball] = 0.0;
}

std::optional<Contact> SweptSolver::collide_balls(World& world, const Event& event) {
    const std::uint32_t i = event.ball;
    const std::uint32_t j = event.other;
    const Path& a = paths_[i];
    const Path& b = paths_[j];
    const Vec2 normal = event.normal;
    const double now = event.time;
    Vec2 velocity_a = velocity_at(world, i, now);
    Vec2 velocity_b = velocity_at(world, j, now);
    if (world.model().spin) {
        advance_spin(world, i, now);
        advance_spin(world, j, now);
    }
    double inverse_a = a.is_frozen ? 0.0 : inverse_mass_[i];
    double inverse_b = b.is_frozen ? 0.0 : inverse_mass_[j];
    const double approach = -dot(velocity_a - velocity_b, normal);
    const double restitution = restitution_of_balls(world, i, j);
    const bool pushed = is_held_ball(i) || is_held_ball(j);
    const auto meets_again = [&](Vec2 va, Vec2 vb) {
        const Vec2 chord_a =
            a.is_frozen || is_held_ball(i) ? va : mean_velocity(world, i, va, gravity_on(i), now);
        const Vec2 chord_b =
            b.is_frozen || is_held_ball(j) ? vb : mean_velocity(world, j, vb, gravity_on(j), now);
        return -dot(chord_a - chord_b, normal) > noise * (length(chord_a) + length(chord_b));
    };
    bool resting = pushed || (restitution < 1.0 && approach < rest_speed_);
    Exchange done{0.0, approach};
    bool is_contact = true;
    if (inverse_a == 0.0 && inverse_b == 0.0) {
        // A held ball goes no further towards a frozen one.
        if (is_held_ball(i) && !a.is_frozen)
            velocity_a += normal * approach;
        else
            velocity_b -= normal * approach;
        is_contact = false;
    } else if (pushed) {
        done = bounce_balls({velocity_a, inverse_a, is_held_ball(i)},
                            {velocity_b, inverse_b, is_held_ball(j)}, normal, restitution);
    } else {
        Vec2 after_a = velocity_a;
        Vec2 after_b = velocity_b;
        if (!resting && approach > 0.0)
            done = bounce(after_a, inverse_a, after_b, inverse_b, normal, restitution);
        if (!resting && meets_again(after_a, after_b)) resting = true;
        if (!resting) {
            velocity_a = after_a;
            velocity_b = after_b;
            is_contact = approach > 0.0;
        } else {
            // A ball that comes to rest on a grounded one does not push it down, except where
            // that would add energy.
            const double speed_a = std::fabs(dot(velocity_a, normal));
            const double speed_b = std::fabs(dot(velocity_b, normal));
            const double up = world.model().gravity ? -dot(normal, *world.model().gravity) : 0.0;
            const bool on_b = up > 0.0 && b.is_grounded && !a.is_frozen && speed_b <= speed_a;
            const bool on_a = up < 0.0 && a.is_grounded && !b.is_frozen && speed_a <= speed_b;
            done = bounce(velocity_a, on_a ? 0.0 : inverse_a, velocity_b, on_b ? 0.0 : inverse_b,
                          normal, approach > 0.0 ? resting_restitution : 0.0);
            is_contact = approach > 0.0;
            if (up > 0.0 && b.is_grounded) rest_on(i, normal, world);
            if (up < 0.0 && a.is_grounded) rest_on(j, -normal, world);
        }
    }
    if (world.model().spin)
        apply_ball_friction(world, event, velocity_a, inverse_a, velocity_b, inverse_b,
                            is_contact ? done.impulse : 0.0, resting);
    for (const std::uint32_t ball : {i, j}) {
        if (!resting && is_contact) end_rest(ball, world);
        count_impact(ball, ball == i ? velocity_a : velocity_b, resting || !is_contact);
    }
    if (world.model().cloth) {
        stop_sliding_if_pressed(world, i, velocity_a);
        stop_sliding_if_pressed(world, j, velocity_b);
    }
    redirect(world, i, now, velocity_a);
    redirect(world, j, now, velocity_b);
    if (!is_contact) return std::nullopt;
    return Contact{.time = now,
                   .kind = ContactKind::ball_ball,
                   .a = std::min(i, j),
                   .b = std::max(i, j),
                   .point = position_at(j, now) + normal * world.balls().radius[j],
                   .normal = i < j ? normal : -normal,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

Vec2 SweptSolver::surface_velocity(const World& world, std::uint32_t capsule, Vec2 point,
                                   double now) const {
    const HeldEdge* const edge = kinematic_edge(capsule);
    return edge ? carom::surface_velocity(*edge, carom::shape_at(*edge, world, now), point)
                : Vec2{};
}

std::optional<Contact> SweptSolver::collide_edge(World& world, const Event& event) {
    const std::uint32_t i = event.ball;
    Path& path = paths_[i];
    const double now = event.time;
    const Vec2 position = position_at(i, now);
    const Vec2 normal = event.normal;
    HeldEdge* const edge = find_edge(std::span<HeldEdge>(kinematic_edges_), event.other);
    const bool is_driven = edge && edge->is_driven;
    const Vec2 surface_motion = edge ? surface_velocity(world, event.other, position, now) : Vec2{};
    const double surface = edge ? dot(surface_motion, normal) : 0.0;
    if (path.is_frozen) {
        // Nothing can move this ball: the kinematic edge that comes against it stops.
        if (edge) {
            edge->stopped_at = now;
            edge->version = 1;
            edge_stopped_ = true;
        }
        return std::nullopt;
    }
    Vec2 velocity = velocity_at(world, i, now);
    if (world.model().spin) advance_spin(world, i, now);
    const double approach = surface - dot(velocity, normal);
    if (is_held_ball(i)) {
        count_impact(i, {}, true);
        redirect(world, i, now, velocity + normal * approach);
        return std::nullopt;
    }
    const double restitution = restitution_of_edge(world, event.other, std::max(0.0, approach));
    const bool pushed = surface > 0.0;
    bool resting = (pushed && !is_driven) || (restitution < 1.0 && approach < rest_speed_);
    Vec2 along = normal;
    Vec2 after = velocity;
    Exchange done{0.0, approach};
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    if (!resting && approach > 0.0) {
        along = bounce_normal(world, i, normal, velocity, restitution);
        done = bounce_off(after, inverse_mass_[i], along, surface, restitution, is_driven);
        if (world.model().kicks)
            after += along * kick_of_edge(world, event.other, shape_at(world, event.other, now),
                                          position, approach);
    }
    if (!resting && dot(mean_velocity(world, i, after, gravity, now), normal) < surface) {
        resting = true;
        along = normal;
        after = velocity;
    }
    const auto apply_friction = [&] {
        apply_edge_friction(world, i, normal, surface_motion, friction_of_edge(world, event.other),
                            done.impulse, after);
    };
    if (!resting) {
        if (world.model().spin) apply_friction();
        if (approach > 0.0) end_rest(i, world);
    } else {
        if (pushed) {
            done = bounce_off(after, inverse_mass_[i], normal, surface,
                              is_driven ? 0.0 : restitution, is_driven);
        } else {
            const double part = approach > 0.0 ? approach * (1.0 + resting_restitution) : approach;
            after = velocity + normal * part;
            done = {part / inverse_mass_[i], approach};
        }
        rest_on(i, normal, world);
        if (world.model().spin) {
            apply_friction();
            if (path.is_resting && resting_[i].support == normal)
                apply_rest_friction(world, i, surface_motion, friction_of_edge(world, event.other),
                                    now, after);
        }
    }
    count_impact(i, after, (resting && !(is_driven && pushed)) || !(approach > 0.0));
    if (world.model().cloth) stop_sliding_if_pressed(world, i, after);
    redirect(world, i, now, after);
    if (!(approach > 0.0)) return std::nullopt;
    return Contact{.time = now,
                   .kind = ContactKind::ball_edge,
                   .a = i,
                   .b = event.other,
                   .point = position - normal * world.balls().radius[i],
                   .normal = along,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

}  // namespace carom
