#include "physics/event/impact/restitution.h"

#include <algorithm>
#include <cmath>

#include "physics/event/motion/tolerances.h"
#include "physics/laws/contact_material.h"

namespace carom {
namespace {

// What bounce_off gives, as a share of the approach.
double share_left(Vec2 velocity, Vec2 normal, double surface, double restitution) {
    const Exchange done = bounce_off(velocity, 1.0, normal, surface, restitution);
    return done.approach > 0.0 ? std::max(0.0, (dot(velocity, normal) - surface) / done.approach)
                               : 0.0;
}

}  // namespace

template <typename Real>
double Restitution<Real>::of(const ContactPoint<Real>& point, bool is_alone) const {
    const Real approach = approach_of<Real>(point.contact, cluster_.motion());
    if (point.is_stop || point.contact.is_hinged) return of_seesaw(point, approach);
    const double usual = point.kind == EventKind::ball_ball ? of_balls(point, is_alone, approach)
                                                            : of_edge(point, is_alone, approach);
    return scene_.world->model().cloth ? on_cloth(point, is_alone, usual) : usual;
}

template <typename Real>
double Restitution<Real>::of_balls(const ContactPoint<Real>& point, bool is_alone,
                                   const Real& approach) const {
    const World& world = *scene_.world;
    const ClusterBody<Real>& body = cluster_.bodies()[point.contact.a];
    const Trajectory<Real> ours = balls_.trajectory(body.ball);
    const Trajectory<Real> theirs = balls_.trajectory(point.other);
    const double restitution = restitution_of_balls(world, body.ball, point.other);
    const bool is_pushed = cluster_.motion()[point.contact.a].inverse_mass == Real{} ||
                           cluster_.motion()[point.contact.b].inverse_mass == Real{};
    const auto is_in_hand = [&](std::uint32_t ball, const Trajectory<Real>& trajectory) {
        return trajectory.motion == Motion::held && is_held(world, world.balls().id[ball]);
    };
    if (is_pushed && is_in_hand(body.ball, ours))
        return off_hand(point.contact.b, point.contact.a, -point.contact.normal, restitution);
    if (is_pushed && is_in_hand(point.other, theirs))
        return off_hand(point.contact.a, point.contact.b, point.contact.normal, restitution);
    if (restitution < 1.0 && ours.recent_collisions > most_recent_collisions &&
        theirs.recent_collisions > most_recent_collisions)
        return 0.0;
    if (!is_alone || !world.model().gravity) return restitution;
    const Real press = -dot(ours.acceleration - theirs.acceleration, point.contact.normal);
    if (!(press > Real{})) return restitution;
    const Real rebound = approach * Real(restitution);
    const Real small = cluster_.smaller_radius(point);
    const Real height = rebound * rebound / (Real(2.0) * press);
    const bool one_rests = body.was_resting || cluster_.bodies()[point.contact.b].was_resting;
    if (one_rests) return height < Real(rest_height) * small ? 0.0 : restitution;
    return height < Real(moving_rest_height) * small ? 1.0 : restitution;
}

// The share of the approach at which a ball leaves a held one, which lies against `normal`.
template <typename Real>
double Restitution<Real>::off_hand(std::uint32_t free, std::uint32_t held,
                                   const Vector<Real>& normal, double restitution) const {
    Vec2 velocity(cluster_.motion()[free].velocity);
    const Vec2 away(normal);
    return share_left(velocity, away, dot(Vec2(cluster_.motion()[held].velocity), away),
                      restitution);
}

template <typename Real>
double Restitution<Real>::of_edge(const ContactPoint<Real>& point, bool is_alone,
                                  const Real& approach) const {
    const World& world = *scene_.world;
    const std::uint32_t ball = cluster_.bodies()[point.contact.a].ball;
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const double speed = static_cast<double>(approach);
    const double surface = static_cast<double>(point.contact.surface);
    const double restitution = restitution_of_edge(world, point.other, std::max(0.0, speed));
    if (point.is_driven && approach > Real{}) {
        const Real pull = length(scene_.field.gravity) * balls_.radius(ball);
        const double least =
            std::sqrt(2.0 * driven_lift_height * static_cast<double>(pull)) / speed;
        return std::max(driven_restitution(restitution, surface, speed), least);
    }
    if (point.kind == EventKind::kinematic_edge && point.contact.surface > Real{}) {
        // Separates the ball fast enough for its next impact to be found (moving_edge_impact.cpp).
        // With less rebound it would sink into the edge, the deeper the longer it is pushed.
        const double height = world.model().cloth ? moving_rest_height : rest_height;
        const Real pull = length(trajectory.acceleration) * balls_.radius(ball);
        if (approach * approach < Real(4.0 * height) * pull) return 1.0;
        return share_left(Vec2(cluster_.motion()[point.contact.a].velocity),
                          Vec2(point.contact.normal), surface, restitution);
    }
    if (restitution < 1.0 && trajectory.recent_collisions > most_recent_collisions &&
        !world.model().gravity)
        return 0.0;
    if (!is_alone || !world.model().gravity) return restitution;
    const Real press = -dot(trajectory.acceleration, point.contact.normal);
    if (!(press > Real{})) return restitution;
    const Real rebound = approach * Real(restitution);
    return rebound * rebound < Real(2.0 * rest_height) * press * balls_.radius(ball) ? 0.0
                                                                                     : restitution;
}

// A ball that lies on a seesaw hops, until the hybrid step takes it over. A stop that only holds a
// seesaw against its load has no restitution of its own.
template <typename Real>
double Restitution<Real>::of_seesaw(const ContactPoint<Real>& point, const Real& approach) const {
    if (point.is_stop) {
        const ClusterBody<Real>& body = cluster_.bodies()[point.contact.a];
        const KinematicEdge<Real>& edge = kinematic_.edges()[body.seesaw];
        return approach > Real{} ? kinematic_.seesaw_of(edge).stop_restitution : 1.0;
    }
    const World& world = *scene_.world;
    const double speed = std::max(0.0, static_cast<double>(approach));
    const double usual = restitution_of_edge(world, point.other, speed);
    if (!world.model().gravity) return usual;
    const std::uint32_t ball = cluster_.bodies()[point.contact.a].ball;
    const Real rebound = approach * Real(usual);
    const Real pull = length(scene_.field.gravity) * balls_.radius(ball);
    return rebound * rebound < Real(2.0 * moving_rest_height) * pull ? 1.0 : usual;
}

template <typename Real>
double Restitution<Real>::on_cloth(const ContactPoint<Real>& point, bool is_alone,
                                   double usual) const {
    if (!is_alone) return usual;
    const std::uint32_t ball = cluster_.bodies()[point.contact.a].ball;
    Vector<Real> acceleration = balls_.curve(ball).acceleration;
    bool is_kinematic =
        point.kind == EventKind::kinematic_edge || balls_[ball].line.motion == Motion::held;
    if (point.kind == EventKind::ball_ball) {
        acceleration -= balls_.curve(point.other).acceleration;
        is_kinematic = is_kinematic || balls_[point.other].line.motion == Motion::held;
    }
    const Real small = cluster_.smaller_radius(point);
    const Real press = -dot(acceleration, point.contact.normal);
    if (!(press > Real{})) return usual;
    const auto rises = [&](double restitution, double height) {
        const Real rebound =
            approach_of<Real>(point.contact, cluster_.motion()) * Real(restitution);
        return !(rebound * rebound < Real(2.0 * height) * press * small);
    };
    if (is_kinematic) return rises(1.0, 2.0 * moving_rest_height) ? usual : 1.0;
    if (point.kind == EventKind::ball_ball) return rises(usual, cloth_rest_height) ? usual : 1.0;
    return rises(usual, rest_height) ? usual : 0.0;
}

template class Restitution<double>;
template class Restitution<DoubleDouble>;

}  // namespace carom
