#include "physics/event/rest/resting_contact.h"

#include "physics/event/motion/tolerances.h"

namespace carom {
namespace {

template <typename Real>
Real rounding_of(const Vector<Real>& gravity) {
    return Real(component_rounding<Real>) * length(gravity);
}

}  // namespace

template <typename Real>
void RestingContact<Real>::settle(std::uint32_t ball) {
    const LinearPart<Real> line = balls_[ball].line;
    if (line.motion != Motion::free) return;
    if (scene_.world->model().cloth) return cloth_.begin_phase(ball);
    if (!scene_.world->model().gravity) return;
    const std::vector<Support<Real>>& supports = supports_.of(ball, false);
    if (const auto two = bearing_two(supports)) {
        const Support<Real>& first = supports[two->first];
        const Support<Real>& second = supports[two->second];
        const Real turn = cross(first.normal, second.normal);
        const Real fall = Real(wedge_rest_heights * rest_height) * length(scene_.field.gravity) *
                          balls_.radius(ball) / (turn * turn);
        if (length_squared(line.velocity) <= fall) {
            const bool spins = scene_.world->model().spin.has_value();
            if (spins && friction_.rolls_off(ball, first, second)) return rest_on_one(ball, first);
            if (spins && friction_.rolls_off(ball, second, first)) return rest_on_one(ball, second);
            return rest_on_two(ball, first, second);
        }
    }
    // A support along which the ball is free to go: as it moves, or else as gravity pulls. In the
    // second case the ball meets the other support later. In free flight it would not, since slow
    // approaches are no impacts.
    for (const bool as_it_moves : {true, false})
        for (std::size_t i = 0; i < supports.size() && supports[i].bears_weight; ++i) {
            bool is_free = true;
            for (std::size_t j = 0; j < supports.size(); ++j)
                if (j != i && (as_it_moves ? leads_against(ball, supports[i], supports[j])
                                           : is_barred(supports[i], supports[j])))
                    is_free = false;
            if (is_free) return rest_on_one(ball, supports[i]);
        }
}

template <typename Real>
void RestingContact<Real>::rest_on_two(std::uint32_t ball, const Support<Real>& first,
                                       const Support<Real>& second) {
    trajectories_.put_to_rest(ball, first.id, second.id);
    if (!scene_.world->model().spin) return;
    const Vector<Real>& gravity = scene_.field.gravity;
    const Real turn = cross(first.normal, second.normal);
    const Real ours = cross(-gravity, second.normal) / turn;
    const Real theirs = cross(first.normal, -gravity) / turn;
    friction_.brake(ball, friction_.coefficient(ball, first.id) * ours +
                              friction_.coefficient(ball, second.id) * theirs);
}

// The ball slides along the support, turns round it, or rests on it.
template <typename Real>
void RestingContact<Real>::rest_on_one(std::uint32_t ball, const Support<Real>& support) {
    const Vector<Real>& gravity = scene_.field.gravity;
    Trajectory<Real> trajectory = balls_.trajectory(ball);
    const Vector<Real> velocity =
        trajectory.velocity - support.normal * dot(trajectory.velocity, support.normal);
    Vector<Real> along = gravity - support.normal * dot(gravity, support.normal);
    if (length(along) <= rounding_of(gravity)) along = {};
    if (scene_.world->model().spin && support.is_side) {
        const auto effect = friction_.on_side(ball, support, velocity, along);
        if (friction_.rest_braced(ball, support, velocity, effect, along + effect.acceleration))
            return;
        along += effect.acceleration;
        trajectories_.spin(ball) = effect.spin;
    }
    const bool is_still = velocity == Vector<Real>{} && along == Vector<Real>{};
    if (!support.is_side && !is_still) {
        const Real circle = length(trajectory.position - support.center);
        const Real press = -dot(gravity, support.normal) - length_squared(velocity) / circle;
        if (!(press > Real{})) return;
        trajectory.center = support.center;
    }
    trajectory.support = support.id;
    trajectory.velocity = velocity;
    trajectory.acceleration = along;
    trajectory.motion =
        is_still ? Motion::resting : (support.is_side ? Motion::sliding : Motion::turning);
    balls_.set_trajectory(ball, trajectory);
}

// Whether a ball that would slide on the support, from rest, is barred by the other.
template <typename Real>
bool RestingContact<Real>::is_barred(const Support<Real>& support,
                                     const Support<Real>& other) const {
    const Vector<Real>& gravity = scene_.field.gravity;
    const Vector<Real> along = gravity - support.normal * dot(gravity, support.normal);
    return dot(along, other.normal) < -rounding_of(gravity);
}

// Whether the ball would go against the other if it slid on the support from now on: by its
// velocity, or where that leads neither way, by gravity's pull.
template <typename Real>
bool RestingContact<Real>::leads_against(std::uint32_t ball, const Support<Real>& support,
                                         const Support<Real>& other) const {
    const Vector<Real>& gravity = scene_.field.gravity;
    const Vector<Real>& normal = support.normal;
    const Vector<Real> velocity = balls_[ball].line.velocity;
    const Real size = balls_.radius(ball);
    const Real rate = dot(velocity - normal * dot(velocity, normal), other.normal);
    const Real rounding = Real(approach_rounding<Real>) * length(velocity) +
                          Real(pressed_rounding) * square_root(scene_.field.pressing * size);
    if (rate < -rounding) return true;
    if (!is_barred(support, other)) return false;
    const Vector<Real> along = gravity - normal * dot(gravity, normal);
    const Real slow = Real(2.0 * rest_height) * -dot(along, other.normal) * size;
    return !(rate > rounding && rate * rate > slow);
}

// The first two supports that between them bear all of gravity.
template <typename Real>
std::optional<std::pair<std::size_t, std::size_t>> RestingContact<Real>::bearing_two(
    const std::vector<Support<Real>>& supports) const {
    const Vector<Real>& gravity = scene_.field.gravity;
    const Real zero{};
    for (std::size_t i = 0; i < supports.size(); ++i)
        for (std::size_t j = i + 1; j < supports.size(); ++j) {
            const Vector<Real>& first = supports[i].normal;
            const Vector<Real>& second = supports[j].normal;
            const Real turn = cross(first, second);
            if (absolute(turn) < Real(parallel_supports)) continue;
            if (!supports[j].bears_weight && !is_barred(supports[i], supports[j])) continue;
            if (!(cross(-gravity, second) / turn < zero) && !(cross(first, -gravity) / turn < zero))
                return std::pair(i, j);
        }
    return std::nullopt;
}

template <typename Real>
void RestingContact<Real>::release_supported(std::uint32_t ball,
                                             std::vector<std::uint32_t>& released) {
    moved_.assign(1, ball);
    while (!moved_.empty()) {
        const std::uint32_t support = moved_.back();
        moved_.pop_back();
        const auto id = number(scene_.world->balls().id[support]);
        space_.for_each_ball_near(support, [&](std::uint32_t other, int, int) {
            const Trajectory<Real> trajectory = balls_.trajectory(other);
            const auto is_support = [id](const SupportId& support) {
                return support.kind == SupportId::Kind::ball && support.number == id;
            };
            if (trajectory.motion == Motion::free ||
                (!is_support(trajectory.support) && !is_support(trajectory.second_support)))
                return;
            const BallState<Real> state = trajectories_.state_now(other);
            if (trajectory.motion == Motion::resting) moved_.push_back(other);
            trajectories_.start(other, scene_.now, state.position, state.velocity);
            balls_[other].line.recent_collisions = trajectory.recent_collisions;
            released.push_back(other);
        });
    }
}

template class RestingContact<double>;
template class RestingContact<DoubleDouble>;

}  // namespace carom
