#include "physics/event/schedule/transitions.h"

#include <algorithm>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/tolerances.h"

namespace carom {
namespace {

// The first time in begin..end at which `value`, which is >= 0 at begin and negative at end, has
// changed its sign, by bisection.
template <typename Real, typename Value>
Real change_of_sign(Value&& value, Real begin, Real end) {
    for (int i = 0; i < 200; ++i) {
        const Real middle = begin + (end - begin) * Real(0.5);
        if (!(begin < middle) || !(middle < end)) break;
        if (value(middle) < Real{})
            end = middle;
        else
            begin = middle;
    }
    return end;
}

template <typename Real>
BallEvent<Real> transition_at(const Real& time) {
    return {time, EventKind::transition, 0, 0, 0, 0};
}

}  // namespace

template <typename Real>
void Transitions<Real>::predict(std::uint32_t ball, BallEvent<Real>& best) {
    const Motion motion = balls_[ball].line.motion;
    if (motion == Motion::free || motion == Motion::held) return;
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    if (is_on_cloth(trajectory)) {
        if (const auto time = cloth_.end_of_phase(ball))
            keep_earlier(ball, transition_at(*time < scene_.now ? scene_.now : *time), best);
        return;
    }
    if (trajectory.motion == Motion::turning) {
        if (const auto time = end_of_turn(ball)) keep_earlier(ball, transition_at(*time), best);
        return;
    }
    if (guard_.is_frozen(trajectory))
        keep_earlier(ball, transition_at(guard_.thaw_time(ball)), best);
    if (scene_.world->model().spin)
        if (const auto time = friction_.end_of_slip(ball, best.time))
            keep_earlier(ball, transition_at(*time < scene_.now ? scene_.now : *time), best);
    if (trajectory.motion == Motion::sliding) predict_end_of_side(ball, trajectory, best);
}

template <typename Real>
void Transitions<Real>::predict_end_of_side(std::uint32_t ball, const Trajectory<Real>& trajectory,
                                            BallEvent<Real>& best) {
    const Edge<Real> edge = scene_.supporting_edge(trajectory.support);
    const Vector<Real> span = edge.end - edge.start;
    const Real whole = length(span);
    const Vector<Real> along = span / whole;
    const Real place = dot(along, trajectory.position - edge.start);
    const Real rate = dot(along, trajectory.velocity);
    const Real acceleration = dot(along, trajectory.acceleration);
    const ToiTolerance<Real> exact{};
    for (const bool to_end : {false, true}) {
        std::optional<Real> time;
        if (is_parabola(trajectory, scene_.field)) {
            const auto since = quadratic_time_of_impact<Real>(
                to_end ? Separation<Real>{whole - place, -rate, -acceleration}
                       : Separation<Real>{place, rate, acceleration},
                exact);
            if (since) time = trajectory.time + *since;
        } else {
            const Real bound = most_acceleration(trajectory, scene_.field, trajectory.time);
            time = first_time_of_impact<Real>(
                [&](const Real& when) -> Separation<Real> {
                    const BallState<Real> state = state_at(trajectory, scene_.field, when);
                    const Real there = dot(along, state.position - edge.start);
                    const Real speed = dot(along, state.velocity);
                    return to_end ? Separation<Real>{whole - there, -speed, Real{}}
                                  : Separation<Real>{there, speed, Real{}};
                },
                trajectory.time, Real(best.time), bound,
                {rounding_at(trajectory.position, whole), Real{}}, search_);
        }
        if (time) keep_earlier(ball, transition_at(*time), best);
    }
}

template <typename Real>
std::optional<Real> Transitions<Real>::end_of_turn(std::uint32_t ball) const {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    Real last = piece_end(trajectory, scene_.field);
    const Turn<Real> first = turn_at(trajectory, scene_.field, trajectory.time);
    const auto shorten = [&](auto&& value) {
        if (!(value(last) < Real{})) return;
        last = change_of_sign<Real>(value, trajectory.time, last);
    };
    const Real zero{};
    if (!(first.speed == zero))
        shorten([&](const Real& time) {
            const Real speed = turn_at(trajectory, scene_.field, time).speed;
            return first.speed < zero ? -speed : speed;
        });
    shorten([&](const Real& time) { return turn_at(trajectory, scene_.field, time).press; });
    if (trajectory.support.kind != SupportId::Kind::edge) return last;
    const bool is_left_turn = !(turn_at(trajectory, scene_.field, last).speed < zero);
    space_.for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int, int) {
        const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
        if (edge.is_point() || !(edge.start == trajectory.center || edge.end == trajectory.center))
            return;
        const Vector<Real> side = perpendicular(edge.end - edge.start);
        for (const Vector<Real>& normal : {side, -side}) {
            // Positive while the side is ahead of the ball.
            const auto ahead = [&](const Vector<Real>& there) {
                return is_left_turn ? cross(there, normal) : cross(normal, there);
            };
            // A side that begins where the ball is must be behind it: else it would support it now.
            const Real here = Real(2.0 * contact_slop) * balls_.radius(ball) / first.radius;
            if (!(ahead(first.normal) > here) || !(dot(first.normal, normal) > zero)) continue;
            shorten([&](const Real& time) {
                return ahead(turn_at(trajectory, scene_.field, time).normal);
            });
        }
    });
    return last;
}

template <typename Real>
const std::vector<std::uint32_t>& Transitions<Real>::handle(std::uint32_t ball) {
    changed_.assign(1, ball);
    if (scene_.world->model().cloth) {
        cloth_.end_phase(ball);
        return changed_;
    }
    const Trajectory<Real> before = balls_.trajectory(ball);
    const BallState<Real> state = trajectories_.state_now(ball);
    if (scene_.world->model().spin) friction_.end_slip(ball);
    trajectories_.start(ball, scene_.now, state.position, state.velocity);
    if (guard_.is_frozen(before) && rest_.is_held_up(ball)) {
        // A frozen ball that its neighbours hold lies on them, even if they have not come to rest.
        balls_[ball].line.motion = Motion::resting;
        balls_.curve(ball).acceleration = {};
        balls_[ball].line.recent_collisions = before.recent_collisions;
        return changed_;
    }
    balls_[ball].line.recent_collisions = before.recent_collisions;
    if (before.motion == Motion::turning) {
        // A turning ball stays on its circle, whatever it touches there, until nothing presses it
        // on. Then it is in free flight; to settle it could put it back, by rounding.
        const bool leaves = !(turn_at(before, scene_.field, scene_.now).press > Real{});
        if (leaves) return changed_;
    }
    rest_.settle(ball);
    if (before.motion == Motion::resting && balls_[ball].line.motion != Motion::resting)
        release_from(ball);
    return changed_;
}

template <typename Real>
void Transitions<Real>::release_from(std::uint32_t ball) {
    released_.clear();
    rest_.release_supported(ball, released_);
    std::sort(released_.begin(), released_.end());
    released_.erase(std::unique(released_.begin(), released_.end()), released_.end());
    for (const std::uint32_t each : released_)
        rest_.settle(each);
    changed_.insert(changed_.end(), released_.begin(), released_.end());
}

template <typename Real>
void Transitions<Real>::restart_in_frame(std::uint32_t ball) {
    const bool on_cloth = scene_.world->model().cloth.has_value();
    const std::uint32_t collisions = balls_[ball].line.recent_collisions;
    const BallState<Real> state = trajectories_.state_now(ball);
    const Vector<Real> roll = on_cloth ? trajectories_.roll_at(ball, scene_.now) : Vector<Real>{};
    trajectories_.start(ball, scene_.now, state.position, state.velocity);
    balls_[ball].line.recent_collisions = collisions;
    if (!on_cloth) return;
    balls_.curve(ball).center = roll;
    cloth_.begin_phase(ball);
}

template class Transitions<double>;
template class Transitions<DoubleDouble>;

}  // namespace carom
