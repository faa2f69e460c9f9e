#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/laws/bounce.h"
#include "physics/swept/solver.h"

// What the solver `swept` does at an impact; finding impacts is in swept_predict.cpp.
namespace carom {
namespace {

// The part of `gravity` that supports against `first` and `second` (unit normals, or 0) leave: the
// nearest acceleration that goes into neither.
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
    if (is_held_ball(ball) || path.still) return path.velocity;
    const double since = now - path.time;
    if (world.model.cloth) return Vec2(on_cloth(world, ball, path.start_velocity, since).velocity);
    const Flight flight = flight_over(world.model.drag, since);
    const Vec2 gravity = gravity_on(ball);
    Vec2 velocity = velocity_after(flight, path.start_velocity, gravity);
    const double pull = length(gravity);
    if (pull > 0.0 && !world.model.drag) {
        const Vec2 down = gravity / pull;
        const double fall = dot(velocity, down);
        const double there = std::sqrt(fall * fall + pull * pull * since * (duration_ - now));
        velocity += down * ((fall < 0.0 ? -there : there) - fall);
    }
    return velocity;
}

// The velocity along the chord of the flight that starts now.
Vec2 SweptSolver::chord(const World& world, std::uint32_t ball, Vec2 velocity, Vec2 gravity,
                        double now) const {
    const double left = duration_ - now;
    if (!(left > 0.0)) return velocity;
    if (world.model.cloth) return Vec2(on_cloth(world, ball, velocity, left).position) / left;
    return travel(flight_over(world.model.drag, left), velocity, gravity) / left;
}

// From now on the ball flies from where it is, at first at `velocity`. Predictions that knew its
// old path are void.
void SweptSolver::take_path(const World& world, std::uint32_t ball, double now, Vec2 velocity) {
    Path& path = paths_[ball];
    path.position = position_at(ball, now);
    path.time = now;
    if (!path.still) path.start_velocity = velocity;
    path.velocity = path.still           ? Vec2{}
                    : is_held_ball(ball) ? velocity
                                         : chord(world, ball, velocity, gravity_on(ball), now);
    const bool is_first = path.version++ == 0;
    if (is_first) ++changed_paths_;
    cells_.enter(ball, box_of_path(world, ball, now), is_first && !are_all_in_cells_);
}

// The ball leaves the impact at `velocity`.
void SweptSolver::count_impact(std::uint32_t ball, Vec2 velocity, bool resting) {
    Path& path = paths_[ball];
    if (path.still) return;
    ++path.impacts;
    if (resting) ++path.resting_impacts;
    const int most = most_resting_impacts * (slides_first_ ? 2 : 1);
    if (path.resting_impacts < most && path.impacts < most_impacts) return;
    path.still = true;
    path.carried = true;
    path.start_velocity = keeps_energy_ ? velocity : Vec2{};
}

// The ball has come to rest on what lies against `normal`, which does not give way.
void SweptSolver::rest_on(std::uint32_t ball, Vec2 normal, const World& world) {
    if (!world.model.gravity || !(dot(normal, *world.model.gravity) < 0.0)) return;
    Path& path = paths_[ball];
    path.carried = true;
    Bearing& bearing = bearings_[ball];
    if (!path.is_borne) bearing = {};
    path.is_borne = true;
    if (dot(bearing.support, normal) < 0.999) bearing.other_support = bearing.support;
    bearing.support = normal;
    bearing.gravity = left_by_supports(gravity_, bearing.support, bearing.other_support);
    if (world.model.spin) spin_rate_[ball] = 0.0;
}

// A bounce takes the ball off what it rested on.
void SweptSolver::let_go(std::uint32_t ball, const World& world) {
    Path& path = paths_[ball];
    path.is_borne = false;
    path.carried = path.still;
    if (world.model.spin) spin_rate_[ball] = 0.0;
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
    if (world.model.spin) {
        advance_spin(world, i, now);
        advance_spin(world, j, now);
    }
    double inverse_a = a.still ? 0.0 : inverse_mass_[i];
    double inverse_b = b.still ? 0.0 : inverse_mass_[j];
    const double approach = -dot(velocity_a - velocity_b, normal);
    double restitution =
        world.model.lossy ? std::min(world.balls.restitution[i], world.balls.restitution[j]) : 1.0;
    const bool pushed = is_held_ball(i) || is_held_ball(j);
    const auto meets_again = [&](Vec2 va, Vec2 vb) {
        const Vec2 chord_a =
            a.still || is_held_ball(i) ? va : chord(world, i, va, gravity_on(i), now);
        const Vec2 chord_b =
            b.still || is_held_ball(j) ? vb : chord(world, j, vb, gravity_on(j), now);
        return -dot(chord_a - chord_b, normal) > noise * (length(chord_a) + length(chord_b));
    };
    bool resting = pushed || (restitution < 1.0 && approach < resting_speed_);
    Exchange done{0.0, approach};
    bool is_contact = true;
    if (inverse_a == 0.0 && inverse_b == 0.0) {
        // A hand against a ball that lies still: the hand goes no further that way.
        if (is_held_ball(i) && !a.still)
            velocity_a += normal * approach;
        else
            velocity_b -= normal * approach;
        is_contact = false;
    } else if (pushed && is_held_ball(i)) {
        done = bounce_off(velocity_b, inverse_b, -normal, dot(velocity_a, -normal), restitution);
    } else if (pushed) {
        done = bounce_off(velocity_a, inverse_a, normal, dot(velocity_b, normal), restitution);
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
            // What rests on a carried ball does not push it down; never where that would add
            // energy.
            const double speed_a = std::fabs(dot(velocity_a, normal));
            const double speed_b = std::fabs(dot(velocity_b, normal));
            const double up = world.model.gravity ? -dot(normal, *world.model.gravity) : 0.0;
            const bool on_b = up > 0.0 && b.carried && !a.still && speed_b <= speed_a;
            const bool on_a = up < 0.0 && a.carried && !b.still && speed_a <= speed_b;
            done = bounce(velocity_a, on_a ? 0.0 : inverse_a, velocity_b, on_b ? 0.0 : inverse_b,
                          normal, approach > 0.0 ? resting_restitution : 0.0);
            is_contact = approach > 0.0;
            if (up > 0.0 && b.carried) rest_on(i, normal, world);
            if (up < 0.0 && a.carried) rest_on(j, -normal, world);
        }
    }
    if (world.model.spin)
        rub_balls(world, event, velocity_a, inverse_a, velocity_b, inverse_b,
                  is_contact ? done.impulse : 0.0, resting);
    for (const std::uint32_t ball : {i, j}) {
        if (!resting && is_contact) let_go(ball, world);
        count_impact(ball, ball == i ? velocity_a : velocity_b, resting || !is_contact);
    }
    if (world.model.cloth) {
        stop_sliding_if_pressed(world, i, velocity_a);
        stop_sliding_if_pressed(world, j, velocity_b);
    }
    take_path(world, i, now, velocity_a);
    take_path(world, j, now, velocity_b);
    if (!is_contact) return std::nullopt;
    return Contact{.time = now,
                   .kind = ContactKind::ball_ball,
                   .a = std::min(i, j),
                   .b = std::max(i, j),
                   .point = position_at(j, now) + normal * world.balls.radius[j],
                   .normal = i < j ? normal : -normal,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

Vec2 SweptSolver::surface_velocity(const World& world, std::uint32_t capsule, Vec2 point,
                                   double now) const {
    const Hand* hand = hand_of(capsule);
    if (!hand || hand->stopped_at >= 0.0) return {};
    const Capsule shape = shape_at(world, capsule, now);
    const double place = closest_parameter(shape.start, shape.end, point);
    return hand->start_velocity + (hand->end_velocity - hand->start_velocity) * place;
}

std::optional<Contact> SweptSolver::collide_edge(World& world, const Event& event) {
    const std::uint32_t i = event.ball;
    Path& path = paths_[i];
    const double now = event.time;
    const Vec2 position = position_at(i, now);
    const Vec2 normal = event.normal;
    const Hand* const mover = hand_of(event.other);
    const bool by_hand = mover != nullptr;
    const bool is_driven = by_hand && mover->is_driven;
    const Vec2 surface_way = by_hand ? surface_velocity(world, event.other, position, now) : Vec2{};
    const double surface = by_hand ? dot(surface_way, normal) : 0.0;
    if (path.still) {
        // Nothing can move this ball: the hand that comes against it stops.
        for (Hand& hand : hands_) {
            if (hand.index != event.other) continue;
            hand.stopped_at = now;
            hand.version = 1;
            hand_stopped_ = true;
        }
        return std::nullopt;
    }
    Vec2 velocity = velocity_at(world, i, now);
    if (world.model.spin) advance_spin(world, i, now);
    const double approach = surface - dot(velocity, normal);
    if (is_held_ball(i)) {
        count_impact(i, {}, true);
        take_path(world, i, now, velocity + normal * approach);
        return std::nullopt;
    }
    const Material& material = world.materials[world.capsules.material[event.other]];
    const double restitution =
        world.model.lossy ? restitution_at(material, std::max(0.0, approach)) : 1.0;
    const bool pushed = surface > 0.0;
    bool resting = (pushed && !is_driven) || (restitution < 1.0 && approach < resting_speed_);
    Vec2 along = normal;
    Vec2 after = velocity;
    Exchange done{0.0, approach};
    const Vec2 gravity = world.model.gravity.value_or(Vec2{});
    if (!resting && approach > 0.0) {
        if (world.model.scatter)
            along = scattered_normal(world, world.balls.id[i], world.balls.edge_contacts[i]++,
                                     normal, velocity, restitution);
        done = bounce_off(after, inverse_mass_[i], along, surface, restitution, is_driven);
        if (world.model.kicks)
            after +=
                along * kick_at(material, shape_at(world, event.other, now), position, approach);
    }
    if (!resting && dot(chord(world, i, after, gravity, now), normal) < surface) {
        resting = true;
        along = normal;
        after = velocity;
    }
    const auto rub = [&] {
        rub_edge(world, i, normal, surface_way, material.friction, done.impulse, after);
    };
    if (!resting) {
        if (world.model.spin) rub();
        if (approach > 0.0) let_go(i, world);
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
        if (world.model.spin) {
            rub();
            if (path.is_borne && bearings_[i].support == normal)
                hold_back(world, i, surface_way, material.friction, now, after);
        }
    }
    count_impact(i, after, (resting && !(is_driven && pushed)) || !(approach > 0.0));
    if (world.model.cloth) stop_sliding_if_pressed(world, i, after);
    take_path(world, i, now, after);
    if (!(approach > 0.0)) return std::nullopt;
    return Contact{.time = now,
                   .kind = ContactKind::ball_edge,
                   .a = i,
                   .b = event.other,
                   .point = position - normal * world.balls.radius[i],
                   .normal = along,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

}  // namespace carom
