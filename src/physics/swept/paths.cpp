#include "physics/swept/paths.h"

#include <algorithm>
#include <cmath>

#include "physics/broad_phase/cell_frame.h"
#include "physics/swept/division.h"
#include "physics/swept/tolerances.h"
#include "physics/tick/kinematic.h"
#include "physics/world/solver_access.h"

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

SweptSubstep swept_substep(const World& world, double duration) {
    const Model& model = world.model();
    SweptSubstep step;
    step.duration = duration;
    step.terms = terms_of(world);
    step.flight = flight_over(model.drag, step.duration);
    step.gravity = model.gravity.value_or(Vec2{});
    step.torus = model.wrap ? size(*model.wrap) : Vec2{};
    step.rest_speed =
        model.gravity ? swept_tolerance::resting_approach * length(*model.gravity) * step.duration
                      : 0.0;
    const bool is_held = !world.held_balls().empty() || !world.held_capsules().empty();
    step.keeps_energy = !model.inelastic && !is_held;
    step.counts_lifts = model.gravity && !model.cloth && !is_held;
    return step;
}

void SweptPaths::begin_tick(const World& world) {
    inverse_mass_ = world.balls().inverse_mass;
    make_held_balls_immovable(world, inverse_mass_);
    standing_.clear();
}

void SweptPaths::begin(const World& world, double share_of_displacement) {
    const Balls& balls = world.balls();
    paths_.resize(balls.size());
    resting_.resize(world.model().gravity ? balls.size() : 0);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Vec2 velocity = balls.velocity[i];
        if (world.model().speed_limit) velocity = limited(velocity, *world.model().speed_limit);
        paths_[i] = SweptPath{.chord = {.position = balls.position[i]}, .start_velocity = velocity};
        paths_[i].chord.velocity =
            world.model().cloth
                ? chord_velocity(world, static_cast<std::uint32_t>(i), velocity, step_.gravity, 0.0)
                : travel(step_.flight, velocity, step_.gravity) / step_.duration;
    }
    for (const HeldBall& held : world.held_balls()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        paths_[*index].chord.velocity =
            displacement_to_target(world, held, balls.position[*index]) *
            (share_of_displacement / step_.duration);
    }
    spin_rate_.assign(world.model().spin ? balls.size() : 0, 0.0);
}

void SweptPaths::finish(World& world) const {
    Balls& balls = SolverAccess(world).balls();
    const Model& model = world.model();
    const bool wraps = model.wrap.has_value();
    const bool turns = model.spin.has_value();
    const bool is_limited = model.speed_limit.has_value();
    const Flight whole = step_.flight;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const auto ball = static_cast<std::uint32_t>(i);
        const SweptPath& path = paths_[i];
        const double since = step_.duration - path.chord.time;
        const Vec2 position = path.chord.position_at(step_.duration);
        balls.position[i] = wraps ? wrapped(position, *model.wrap) : position;
        if (turns) finish_turning(world, ball, since);
        if (path.is_frozen || is_held(ball)) {
            balls.velocity[i] = is_held(ball) ? Vec2{} : path.start_velocity;
            continue;
        }
        if (turns && model.cloth) continue;
        const Vec2 velocity =
            velocity_after(path.chord.time == 0.0 ? whole : flight_over(model.drag, since),
                           path.start_velocity, gravity_on(ball));
        balls.velocity[i] = is_limited ? limited(velocity, *model.speed_limit) : velocity;
    }
}

void SweptPaths::stop_far_balls(const World& world) {
    for (std::uint32_t i = 0; i < paths_.size(); ++i) {
        SweptPath& path = paths_[i];
        const double length_of_path = length(path.chord.velocity) * step_.duration;
        if (is_held(i) || !is_far(length_of_path, world.balls().radius[i])) continue;
        path.chord.velocity = {};
        mark_standing(i);
    }
}

Vec2 SweptPaths::velocity_at(const World& world, std::uint32_t ball, double now) const {
    const SweptPath& path = paths_[ball];
    if (is_held(ball) || path.is_frozen) return path.chord.velocity;
    const double since = now - path.chord.time;
    if (world.model().cloth)
        return Vec2(on_cloth(world, ball, path.start_velocity, since).velocity);
    const Flight flight = flight_over(world.model().drag, since);
    const Vec2 gravity = gravity_on(ball);
    Vec2 velocity = velocity_after(flight, path.start_velocity, gravity);
    const double pull = length(gravity);
    if (pull > 0.0 && !world.model().drag) {
        const Vec2 down = gravity / pull;
        const double fall = dot(velocity, down);
        const double there = std::sqrt(fall * fall + pull * pull * since * (step_.duration - now));
        velocity += down * ((fall < 0.0 ? -there : there) - fall);
    }
    return velocity;
}

Vec2 SweptPaths::chord_velocity(const World& world, std::uint32_t ball, Vec2 velocity, Vec2 gravity,
                                double now) const {
    const double left = step_.duration - now;
    if (world.model().cloth && left > 0.0)
        return Vec2(on_cloth(world, ball, velocity, left).position) / left;
    return carom::chord_velocity(world.model().drag, velocity, gravity, left);
}

bool SweptPaths::redirect(const World& world, std::uint32_t ball, double now, Vec2 velocity) {
    SweptPath& path = paths_[ball];
    path.chord.position = position_at(ball, now);
    path.chord.time = now;
    if (path.is_frozen) {
        path.chord.velocity = {};
    } else {
        path.start_velocity = velocity;
        path.chord.velocity =
            is_held(ball) ? velocity : chord_velocity(world, ball, velocity, gravity_on(ball), now);
    }
    return path.version++ == 0;
}

void SweptPaths::count_resting_impact(const World& world, std::uint32_t ball, Vec2 velocity) {
    SweptPath& path = paths_[ball];
    if (path.is_frozen) return;
    ++path.resting_impacts;
    const std::uint32_t most =
        swept_tolerance::most_resting_impacts * (world.model().cloth ? 2u : 1u);
    if (path.resting_impacts < most) return;
    path.is_frozen = true;
    path.is_grounded = true;
    path.start_velocity = step_.keeps_energy ? velocity : Vec2{};
    if (!step_.keeps_energy) return;
    path.is_standing = true;
    standing_.push_back(ball);
}

void SweptPaths::stand_still(World& world, std::uint32_t ball, double now) {
    const Vec2 velocity = velocity_at(world, ball, now);
    if (world.model().spin) {
        advance_spin(world, ball, now);
        spin_rate_[ball] = 0.0;
    }
    paths_[ball].start_velocity = velocity;
    mark_standing(ball);
}

void SweptPaths::mark_standing(std::uint32_t ball) {
    SweptPath& path = paths_[ball];
    path.is_frozen = true;
    path.is_grounded = true;
    path.is_standing = true;
    standing_.push_back(ball);
}

void SweptPaths::rest_on(const World& world, std::uint32_t ball, Vec2 normal, double follow) {
    if (!world.model().gravity || !(dot(normal, step_.gravity) < 0.0)) return;
    SweptPath& path = paths_[ball];
    path.is_grounded = true;
    SweptRest& rest = resting_[ball];
    if (!path.is_resting) rest = {};
    path.is_resting = true;
    if (dot(rest.support, normal) < 0.999) rest.other_support = rest.support;
    rest.support = normal;
    rest.gravity = left_by_supports(step_.gravity, rest.support, rest.other_support);
    rest.borne = rest.gravity - step_.gravity;
    if (follow != 0.0) rest.gravity += normal * follow;
    if (world.model().spin) spin_rate_[ball] = 0.0;
}

}  // namespace carom
