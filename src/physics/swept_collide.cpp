#include <algorithm>

#include "geometry/closest.h"
#include "physics/bounce.h"
#include "physics/swept_solver.h"

// What the solver `swept` does at an impact; finding impacts is in swept_solver.cpp.
namespace carom {

// From now on the ball goes from where it is at `velocity`. Predictions that knew its old path are
// void.
void SweptSolver::take_path(const World& world, std::uint32_t ball, double now, Vec2 velocity) {
    Path& path = paths_[ball];
    path.position = position_at(ball, now);
    path.time = now;
    path.velocity = path.still ? Vec2{} : velocity;
    ++path.version;
    const Vec2 to = path.position + path.velocity * (duration_ - now);
    cells_.enter(ball,
                 grow(join({path.position, path.position}, {to, to}), world.balls.radius[ball]));
}

void SweptSolver::count_impact(std::uint32_t ball, bool resting) {
    Path& path = paths_[ball];
    ++path.impacts;
    if (resting) ++path.resting_impacts;
    if (path.resting_impacts < most_resting_impacts && path.impacts < most_impacts) return;
    path.still = true;
    path.carried = true;
}

// The ball has come to rest on what lies against `normal`, which does not give way.
void SweptSolver::rest_on(std::uint32_t ball, Vec2 normal, const World& world) {
    if (!world.model.gravity || !(dot(normal, *world.model.gravity) < 0.0)) return;
    Path& path = paths_[ball];
    path.carried = true;
    if (dot(path.support, normal) < 0.999) path.other_support = path.support;
    path.support = normal;
}

std::optional<Contact> SweptSolver::collide_balls(World& world, const Event& event) {
    const std::uint32_t i = event.ball;
    const std::uint32_t j = event.other;
    Path& a = paths_[i];
    Path& b = paths_[j];
    const Vec2 normal = event.normal;
    const double now = event.time;
    Vec2 velocity_a = a.velocity;
    Vec2 velocity_b = b.velocity;
    double inverse_a = a.still ? 0.0 : inverse_mass_[i];
    double inverse_b = b.still ? 0.0 : inverse_mass_[j];
    const double approach = -dot(velocity_a - velocity_b, normal);
    double restitution =
        world.model.lossy ? std::min(world.balls.restitution[i], world.balls.restitution[j]) : 1.0;
    const bool pushed = is_held_ball(i) || is_held_ball(j);
    const bool resting = pushed || (restitution < 1.0 && approach < resting_speed_);
    std::optional<Contact> contact =
        Contact{.time = now,
                .kind = ContactKind::ball_ball,
                .a = std::min(i, j),
                .b = std::max(i, j),
                .point = position_at(j, now) + normal * world.balls.radius[j],
                .normal = i < j ? normal : -normal};
    Exchange done{0.0, approach};
    if (inverse_a == 0.0 && inverse_b == 0.0) {
        // A hand against a ball that lies still: the hand goes no further that way.
        (is_held_ball(i) ? velocity_a : velocity_b) +=
            normal * (is_held_ball(i) ? approach : -approach);
        contact.reset();
    } else if (pushed && inverse_a == 0.0 && is_held_ball(i)) {
        done = bounce_off(velocity_b, inverse_b, -normal, dot(velocity_a, -normal), restitution);
    } else if (pushed && inverse_b == 0.0 && is_held_ball(j)) {
        done = bounce_off(velocity_a, inverse_a, normal, dot(velocity_b, normal), restitution);
    } else {
        if (resting) restitution = std::min(restitution, resting_restitution);
        // What rests on a carried ball does not push it down; never where that would add energy.
        const double speed_a = std::abs(dot(velocity_a, normal));
        const double speed_b = std::abs(dot(velocity_b, normal));
        const double up = world.model.gravity ? -dot(normal, *world.model.gravity) : 0.0;
        const bool on_b = resting && up > 0.0 && b.carried && speed_b <= speed_a;
        const bool on_a = resting && up < 0.0 && a.carried && speed_a <= speed_b;
        if (on_b) inverse_b = 0.0;
        if (on_a) inverse_a = 0.0;
        done = bounce(velocity_a, inverse_a, velocity_b, inverse_b, normal, restitution);
        if (on_b) rest_on(i, normal, world);
        if (on_a) rest_on(j, -normal, world);
    }
    for (const std::uint32_t ball : {i, j}) {
        if (!resting) paths_[ball].support = paths_[ball].other_support = {};
        count_impact(ball, resting);
    }
    take_path(world, i, now, velocity_a);
    take_path(world, j, now, velocity_b);
    if (!contact) return std::nullopt;
    contact->approach = done.approach;
    contact->impulse = done.impulse;
    return contact;
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
    const bool by_hand = hand_of(event.other) != nullptr;
    const double surface =
        by_hand ? dot(surface_velocity(world, event.other, position, now), normal) : 0.0;
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
    Vec2 velocity = path.velocity;
    const double approach = surface - dot(velocity, normal);
    if (is_held_ball(i)) {
        count_impact(i, true);
        take_path(world, i, now, velocity + normal * approach);
        return std::nullopt;
    }
    const Material& material = world.materials[world.capsules.material[event.other]];
    double restitution = world.model.lossy ? restitution_at(material, approach) : 1.0;
    const bool resting = surface > 0.0 || (restitution < 1.0 && approach < resting_speed_);
    Vec2 along = normal;
    if (resting) {
        restitution = std::min(restitution, surface > 0.0 ? restitution : resting_restitution);
    } else if (world.model.scatter) {
        along = scattered_normal(world, world.balls.id[i], world.balls.edge_contacts[i]++, normal,
                                 velocity, restitution);
    }
    const Exchange done = bounce_off(velocity, inverse_mass_[i], along, surface, restitution);
    if (resting)
        rest_on(i, normal, world);
    else
        path.support = path.other_support = {};
    count_impact(i, resting);
    take_path(world, i, now, velocity);
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
