#include "physics/event/rest/side_friction.h"

#include "physics/broad_phase/capsule_cells.h"
#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/tolerances.h"
#include "physics/laws/contact_material.h"

namespace carom {

template <typename Real>
Real SideFriction<Real>::coefficient(std::uint32_t ball, const SupportId& support) const {
    if (support.kind == SupportId::Kind::edge) {
        const auto index = index_of(*scene_.world, CapsuleId{support.number});
        return Real(friction_of_edge(*scene_.world, *index));
    }
    if (support.kind != SupportId::Kind::ball) return Real{};
    const auto index = index_of(*scene_.world, BallId{support.number});
    return Real(friction_of_balls(*scene_.world, ball, *index));
}

// Slips up to this are rounding. `change`: how fast friction changes the surface speed, length/s^2.
// A small inertia makes that far faster than gravity.
template <typename Real>
Real SideFriction<Real>::slip_tolerance(std::uint32_t ball, const Vector<Real>& velocity,
                                        const Real& change) const {
    const Real size = balls_.radius(ball);
    const Real pull = length(scene_.field.gravity);
    return Real(slip_rounding<Real>) *
               (length(velocity) + size * absolute(trajectories_.spin(ball).spin) +
                square_root(pull * size)) +
           Real(slip_time_rounding<Real>) * (pull + change) * absolute(scene_.now);
}

template <typename Real>
auto SideFriction<Real>::on_side(std::uint32_t ball, const Support<Real>& support,
                                 const Vector<Real>& velocity, const Vector<Real>& pull) const
    -> Effect {
    Effect effect;
    effect.spin = trajectories_.spin(ball);
    const Real press = -dot(scene_.field.gravity, support.normal);
    const Real most = coefficient(ball, support.id) * press;
    if (!(most > Real{})) return effect;
    const Real inertia(*scene_.world->model().spin);
    const Real size = balls_.radius(ball);
    const Vector<Real> along = perpendicular(support.normal);
    const Real speed = dot(velocity, along);
    const Real slip = speed - size * effect.spin.spin;
    // Drag slows a rolling ball too.
    const Real acceleration =
        dot(pull, along) - (scene_.field.has_drag ? scene_.field.drag * speed : Real{});
    const Real needed = -acceleration / (Real(1.0) + Real(1.0) / inertia);
    Real push = slip < Real{} ? most : -most;
    if (!(absolute(slip) > slip_tolerance(ball, velocity, most / inertia))) {
        push = clamped(needed, most);
        effect.spin.rolls = push == needed;
        if (effect.spin.rolls) effect.spin.spin = speed / size + Real{};  // never -0
    }
    effect.spin.rate = -push / (inertia * size);
    effect.acceleration = along * push;
    return effect;
}

template <typename Real>
void SideFriction<Real>::brake(std::uint32_t ball, const Real& friction) {
    SpinTrajectory<Real>& turn = trajectories_.spin(ball);
    const Real rate = friction / (Real(*scene_.world->model().spin) * balls_.radius(ball));
    turn.rolls = false;
    turn.rate = turn.spin == Real{} ? Real{} : (turn.spin < Real{} ? rate : -rate);
}

template <typename Real>
bool SideFriction<Real>::rest_braced(std::uint32_t ball, const Support<Real>& support,
                                     const Vector<Real>& velocity, const Effect& effect,
                                     const Vector<Real>& acceleration) {
    if (effect.spin.rolls || effect.acceleration == Vector<Real>{}) return false;
    const auto barrier = supports_.barrier_to(ball, velocity, acceleration);
    if (!barrier) return false;
    const Real ours = coefficient(ball, support.id);
    const Real theirs = coefficient(ball, barrier->id);
    const Real press = -dot(scene_.field.gravity, support.normal) / (Real(1.0) + ours * theirs);
    trajectories_.put_to_rest(ball, support.id, barrier->id);
    brake(ball, ours * press * (Real(1.0) + theirs));
    return true;
}

template <typename Real>
bool SideFriction<Real>::rolls_off(std::uint32_t ball, const Support<Real>& side,
                                   const Support<Real>& other) const {
    if (!side.is_side || trajectories_.spin(ball).spin == Real{}) return false;
    const Vector<Real> pull =
        scene_.field.gravity - side.normal * dot(scene_.field.gravity, side.normal);
    const Effect effect = on_side(ball, side, {}, pull);
    return dot(pull + effect.acceleration, other.normal) >
           Real(pressing_share) * length(scene_.field.gravity);
}

template <typename Real>
std::optional<Real> SideFriction<Real>::end_of_slip(std::uint32_t ball, const Real& horizon) {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const SpinTrajectory<Real>& turn = trajectories_.spin(ball);
    if (turn.rolls) {
        if (!scene_.field.has_drag) return std::nullopt;
        return trajectory.time + Real(rolling_piece) / scene_.field.drag;
    }
    if (turn.rate == Real{}) return std::nullopt;
    if (trajectory.motion == Motion::resting) return turn.time - turn.spin / turn.rate;
    // In the direction in which the slip is u - r w, as in laws/bounce.h.
    const Real size = balls_.radius(ball);
    const Vector<Real> along = slip_direction(ball);
    const Real slip = dot(trajectory.velocity, along) - size * turn.spin;
    const Real tolerance = slip_tolerance(ball, trajectory.velocity, size * absolute(turn.rate));
    if (!(absolute(slip) > tolerance)) return std::nullopt;
    const Real sign(slip < Real{} ? -1.0 : 1.0);
    const Real bend = dot(trajectory.acceleration, along) - size * turn.rate;
    if (!scene_.field.has_drag) {
        if (!(bend * sign < Real{})) return std::nullopt;
        return trajectory.time - slip / bend;
    }
    const Real most =
        scene_.field.drag * most_acceleration(trajectory, scene_.field, trajectory.time);
    return first_time_of_impact<Real>(
        [&](const Real& when) -> Separation<Real> {
            const Real speed = dot(state_at(trajectory, scene_.field, when).velocity, along);
            return {sign * (speed - size * trajectories_.spin_at(ball, when)),
                    sign * (bend - scene_.field.drag * speed), Real{}};
        },
        trajectory.time, horizon, most, {tolerance, Real{}}, search_);
}

// To the left of the normal of the side along which the ball slides.
template <typename Real>
Vector<Real> SideFriction<Real>::slip_direction(std::uint32_t ball) const {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const Edge<Real> edge = scene_.supporting_edge(trajectory.support);
    const Vector<Real> span = edge.end - edge.start;
    const Vector<Real> direction = span / length(span);
    const bool is_left = !(cross(span, trajectory.position - edge.start) < Real{});
    return is_left ? -direction : direction;
}

template <typename Real>
void SideFriction<Real>::end_slip(std::uint32_t ball) {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const bool rolled = trajectories_.spin(ball).rolls;
    const bool was_braked =
        trajectory.motion == Motion::resting && !(trajectories_.spin(ball).rate == Real{});
    trajectories_.continue_spin(ball, scene_.now);
    Real& spin = trajectories_.spin(ball).spin;
    // That is why it has this transition. The time of braking may be lost in the rounding of time.
    if (was_braked) spin = Real{};
    if (rolled && trajectory.motion == Motion::sliding && scene_.field.has_drag)
        spin = dot(state_at(trajectory, scene_.field, scene_.now).velocity, slip_direction(ball)) /
               balls_.radius(ball);
}

template class SideFriction<double>;
template class SideFriction<DoubleDouble>;

}  // namespace carom
