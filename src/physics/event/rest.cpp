#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "physics/event/engine.h"

// What carries a ball: sliding along an edge, turning round an end, rest.
namespace carom {
namespace {

// The share of gravity that is rounding.
template <typename Real>
Real noise_of(const Vector<Real>& gravity) {
    return Real(256.0 * precision<Real>) * length(gravity);
}

}  // namespace

// What the ball touches without bouncing: the sides that it is pressed on, then the round ends and
// balls, then what gravity does not press it on, but may bar its way.
template <typename Real>
const std::vector<typename EventEngine<Real>::Support>& EventEngine<Real>::supports_of(
    std::uint32_t ball, bool also_moving) {
    const EventPath<Real> path = balls_.path(ball);
    const Real size = radius(ball);
    std::vector<Support>& sides = supports_;
    std::vector<Support>& points = points_;
    std::vector<Support>& bars = bars_;
    sides.clear();
    points.clear();
    bars.clear();
    // What still moves, moves within the height of a lively hop.
    const Real near = size * Real(also_moving ? 4.0 * lively_rise : touching);
    const auto add = [&](Support& support, std::vector<Support>& carriers) {
        const Real press = -dot(field_.gravity, support.normal);
        support.carries = press > noise_of(field_.gravity);
        const Real pressing = support.carries ? press : length(field_.gravity);
        const Real rate = dot(path.velocity, support.normal);
        const Real noise = Real(256.0 * precision<Real>) * length(path.velocity);
        if (absolute(rate) <= noise || rate * rate <= Real(2.0 * resting_rise) * pressing * size)
            (support.carries ? carriers : bars).push_back(support);
    };
    for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int across, int along) {
        const Edge<Real> edge(world_->capsules.shape[capsule], shift);
        const auto contact = contact_with(edge, path.position, size);
        const Real rounding = Real(16.0) * rounding_at(path.position, size + edge.radius);
        if (contact.gap > near + rounding || !is_solid_for(capsule, path.position, shift)) return;
        Support support;
        support.by = {PathSupport::By::edge, static_cast<std::int8_t>(across),
                      static_cast<std::int8_t>(along), number(world_->capsules.id[capsule])};
        if (!edge.is_point()) {
            const Vector<Real> span = edge.end - edge.start;
            const Real whole = length(span);
            const Vector<Real> direction = span / whole;
            const Real place = dot(direction, path.position - edge.start);
            const Real slack = (near + rounding) * Real(4.0);
            const Vector<Real> left = perpendicular(direction);
            const Vector<Real> normal =
                dot(left, path.position - edge.start) < Real{} ? -left : left;
            // At an end the way that it goes decides whether it is beside the edge.
            Real way = dot(direction, path.velocity);
            if (absolute(way) <= Real(256.0 * precision<Real>) * length(path.velocity))
                way = dot(direction, field_.gravity);
            const bool is_side = (place > slack && place < whole - slack) ||
                                 (place >= -slack && place <= slack && way > Real{}) ||
                                 (place >= whole - slack && place <= whole + slack && way < Real{});
            if (is_side) {
                support.normal = normal;
                support.is_side = true;
                add(support, sides);
                return;
            }
            support.center = place < whole * Real(0.5) ? edge.start : edge.end;
        } else {
            support.center = edge.start;
        }
        const Vector<Real> arm = path.position - support.center;
        const Real away = length(arm);
        if (!(away > Real{})) return;
        support.normal = arm / away;
        add(support, points);
    });
    const auto with_ball = [&](std::uint32_t other, int across, int along) {
        if (!balls_meet(ball, other)) return;
        if (!also_moving && balls_[other].line.motion != Motion::resting) return;
        Support support;
        support.center =
            state_at(balls_.path(other), field_, now_).position + torus_shift(across, along);
        const Vector<Real> arm = path.position - support.center;
        const Real away = length(arm);
        const Real reach = size + radius(other);
        if (!(away > Real{}) ||
            away - reach > near + Real(16.0) * rounding_at(path.position, reach))
            return;
        support.normal = arm / away;
        support.by = {PathSupport::By::ball, static_cast<std::int8_t>(across),
                      static_cast<std::int8_t>(along), number(world_->balls.id[other])};
        add(support, points);
    };
    for_each_ball_near(ball, with_ball);
    // By number, wherever the cells are.
    for (std::vector<Support>* const some : {&points, &bars}) {
        std::sort(some->begin(), some->end(), [](const Support& a, const Support& b) {
            const auto key = [](const PathSupport& by) {
                return std::tuple(by.by, by.number, by.across, by.along);
            };
            return key(a.by) < key(b.by);
        });
        sides.insert(sides.end(), some->begin(), some->end());
    }
    return sides;
}

// Whether what would slide on the support, from rest, is kept from it by the other.
template <typename Real>
bool EventEngine<Real>::is_barred(const Support& support, const Support& other) const {
    const Vector<Real>& normal = support.normal;
    const Vector<Real> along = field_.gravity - normal * dot(field_.gravity, normal);
    return dot(along, other.normal) < -noise_of(field_.gravity);
}

// Whether the ball would go on against the other if it slid on the support from now on: as fast as
// it is, or, where that leads neither way, as it is pulled.
template <typename Real>
bool EventEngine<Real>::leads_against(std::uint32_t ball, const Support& support,
                                      const Support& other) const {
    const Vector<Real>& normal = support.normal;
    const Vector<Real> velocity = balls_[ball].line.velocity;
    const Real size = radius(ball);
    const Real rate = dot(velocity - normal * dot(velocity, normal), other.normal);
    const Real noise = Real(impact_noise<Real>) * length(velocity) +
                       Real(pressing_noise) * square_root(field_.pressing * size);
    if (rate < -noise) return true;
    if (!is_barred(support, other)) return false;
    const Vector<Real> along = field_.gravity - normal * dot(field_.gravity, normal);
    const Real slow = Real(2.0 * resting_rise) * -dot(along, other.normal) * size;
    return !(rate > noise && rate * rate > slow);
}

// Two that between them bear all of gravity, the first such pair.
template <typename Real>
std::optional<std::pair<std::size_t, std::size_t>> EventEngine<Real>::bearing_two(
    const std::vector<Support>& supports) const {
    const Real zero{};
    for (std::size_t i = 0; i < supports.size(); ++i)
        for (std::size_t j = i + 1; j < supports.size(); ++j) {
            const Vector<Real>& first = supports[i].normal;
            const Vector<Real>& second = supports[j].normal;
            const Real turn = cross(first, second);
            if (absolute(turn) < Real(1e-9)) continue;
            if (!supports[j].carries && !is_barred(supports[i], supports[j])) continue;
            if (!(cross(-field_.gravity, second) / turn < zero) &&
                !(cross(first, -field_.gravity) / turn < zero))
                return std::pair(i, j);
        }
    return std::nullopt;
}

// Decides on what a ball that has just begun a path lies, if on anything.
template <typename Real>
void EventEngine<Real>::settle(std::uint32_t ball) {
    const EventLine<Real> path = balls_[ball].line;
    if (path.motion != Motion::free) return;
    if (world_->model.cloth) return begin_phase(ball);
    if (!world_->model.gravity) return;
    const std::vector<Support>& supports = supports_of(ball, false);
    if (const auto two = bearing_two(supports)) {
        const Real turn = cross(supports[two->first].normal, supports[two->second].normal);
        const Real fall =
            Real(8.0 * resting_rise) * length(field_.gravity) * radius(ball) / (turn * turn);
        if (length_squared(path.velocity) <= fall) {
            const Support& first = supports[two->first];
            const Support& second = supports[two->second];
            if (world_->model.spin && rolls_off(ball, first, second))
                return rest(ball, first, nullptr);
            if (world_->model.spin && rolls_off(ball, second, first))
                return rest(ball, second, nullptr);
            return rest(ball, first, &second);
        }
    }
    // Where its speed leads against something from each, one of those along which gravity does not:
    // the ball meets that then. If it fell, slow approaches would be none (event_closing.h).
    for (const bool is_free_to_go : {true, false})
        for (std::size_t i = 0; i < supports.size() && supports[i].carries; ++i) {
            bool is_free = true;
            for (std::size_t j = 0; j < supports.size(); ++j)
                if (j != i && (is_free_to_go ? leads_against(ball, supports[i], supports[j])
                                             : is_barred(supports[i], supports[j])))
                    is_free = false;
            if (is_free) return rest(ball, supports[i], nullptr);
        }
}

template <typename Real>
void EventEngine<Real>::rest(std::uint32_t ball, const Support& first, const Support* second) {
    if (second) {
        lay_down(ball, first.by, second->by);
        if (world_->model.spin) {
            const Real turn = cross(first.normal, second->normal);
            const Real ours = cross(-field_.gravity, second->normal) / turn;
            const Real theirs = cross(first.normal, -field_.gravity) / turn;
            brake_spin(ball,
                       friction_of(ball, first.by) * ours + friction_of(ball, second->by) * theirs);
        }
        return;
    }
    EventPath<Real> path = balls_.path(ball);
    const Vector<Real> velocity = path.velocity - first.normal * dot(path.velocity, first.normal);
    Vector<Real> along = field_.gravity - first.normal * dot(field_.gravity, first.normal);
    if (length(along) <= noise_of(field_.gravity)) along = {};
    Rub rub;
    if (world_->model.spin && first.is_side) {
        rub = rub_on_side(ball, first, velocity, along);
        if (is_braced(ball, first, velocity, rub, along + rub.acceleration)) return;
        along += rub.acceleration;
        spins_[ball] = rub.turn;
    }
    const bool is_still = velocity == Vector<Real>{} && along == Vector<Real>{};
    if (!first.is_side && !is_still) {
        const Real circle = length(path.position - first.center);
        const Real press = -dot(field_.gravity, first.normal) - length_squared(velocity) / circle;
        if (!(press > Real{})) return;
        path.center = first.center;
    }
    path.support = first.by;
    path.velocity = velocity;
    path.acceleration = along;
    path.motion = is_still ? Motion::resting : (first.is_side ? Motion::sliding : Motion::turning);
    balls_.set_path(ball, path);
}

template <typename Real>
void EventEngine<Real>::lay_down(std::uint32_t ball, const PathSupport& support,
                                 const PathSupport& second_support) {
    EventPath<Real> path = balls_.path(ball);
    path.motion = Motion::resting;
    path.velocity = path.acceleration = {};
    path.support = support;
    path.second_support = second_support;
    balls_.set_path(ball, path);
}

// The ball's support has changed its path: what lies on it flies, until it settles again.
template <typename Real>
void EventEngine<Real>::release_what_rests_on(std::uint32_t ball,
                                              std::vector<std::uint32_t>& released) {
    std::vector<std::uint32_t>& gone = gone_;
    gone.assign(1, ball);
    while (!gone.empty()) {
        const std::uint32_t support = gone.back();
        gone.pop_back();
        const auto id = number(world_->balls.id[support]);
        const auto look = [&](std::uint32_t other, int, int) {
            const EventPath<Real> path = balls_.path(other);
            const auto is = [id](const PathSupport& by) {
                return by.by == PathSupport::By::ball && by.number == id;
            };
            if (path.motion == Motion::free || (!is(path.support) && !is(path.second_support)))
                return;
            const BallState<Real> state = state_at(path, field_, now_);
            if (path.motion == Motion::resting) gone.push_back(other);
            const std::uint32_t quick = path.quick;
            start_path(other, now_, state.position, state.velocity);
            balls_[other].line.quick = quick;
            released.push_back(other);
        };
        for_each_ball_near(support, look);
    }
}

// The ball has come to the end of the side along which it slid, or of a piece of its turn.
template <typename Real>
void EventEngine<Real>::end_own(std::uint32_t ball) {
    if (world_->model.cloth) return end_phase(ball);
    const EventPath<Real> before = balls_.path(ball);
    const BallState<Real> state = state_at(before, field_, now_);
    if (world_->model.spin) end_spin(ball);
    start_path(ball, now_, state.position, state.velocity);
    if (before.motion == Motion::resting && bearing_two(supports_of(ball, true))) {
        // Tired, and what it touches carries it, though that may not have come to rest: on it lies.
        balls_[ball].line.motion = Motion::resting;
        balls_.bend(ball).acceleration = {};
        balls_[ball].line.quick = before.quick;
        predict(ball);
        return;
    }
    balls_[ball].line.quick = before.quick;
    if (before.motion == Motion::turning) {
        // The ball of a turn keeps to its circle, whatever else it touches there, until it leaves.
        const Turn<Real> turn = turn_at(before, field_, now_);
        if (!(turn.press > Real{})) {
            // Rounding must not put it back on.
            predict(ball);
            return;
        }
    }
    settle(ball);
    if (before.motion == Motion::resting && balls_[ball].line.motion != Motion::resting) {
        std::vector<std::uint32_t>& released = changed_;
        released.clear();
        release_what_rests_on(ball, released);
        std::sort(released.begin(), released.end());
        released.erase(std::unique(released.begin(), released.end()), released.end());
        for (const std::uint32_t each : released)
            settle(each);
        predict(ball);
        reorder(ball);
        for (const std::uint32_t each : released) {
            predict(each);
            reorder(each);
        }
        return;
    }
    predict(ball);
}

// How long a ball takes to fall through its radius.
template <typename Real>
Real EventEngine<Real>::fall_time(std::uint32_t ball) const {
    return square_root(Real(2.0) * radius(ball) / length(field_.gravity));
}

// One more for an impact in quick succession, fewer for a time without.
template <typename Real>
std::uint32_t EventEngine<Real>::tiredness(std::uint32_t ball,
                                           const EventPath<Real>& before) const {
    const Real quick = fall_time(ball) * Real(quick_succession);
    const double pauses = static_cast<double>((now_ - before.time) / quick);
    if (pauses < 1.0) return one_more(before.quick);
    return pauses < before.quick ? before.quick - static_cast<std::uint32_t>(pauses) : 0;
}

// What is shut in gives up sooner, and where nothing else loses energy, too: its impacts are stops.
template <typename Real>
void EventEngine<Real>::lie_down_if_tired(std::uint32_t ball, bool is_shut_in) {
    const EventLine<Real>& path = balls_[ball].line;
    const bool is_tired =
        is_shut_in ? path.quick > most_quick : path.quick > most_tiring && world_->model.lossy;
    if (!is_tired || !world_->model.gravity) return;
    if (path.motion == Motion::resting || path.motion == Motion::held) return;
    // Fast balls that rattle in a narrow place go on.
    if (Real(2.0) * length(field_.gravity) * radius(ball) < length_squared(path.velocity)) return;
    lay_down(ball, {}, {});
    if (world_->model.spin) spins_[ball] = {now_, Real{}, Real{}, false};
    balls_[ball].line.quick = most_tiring / 4 * 3;
}

template <typename Real>
void EventEngine<Real>::note_crowded(std::size_t body) {
    if (!world_->model.gravity || !world_->model.lossy) return;
    const std::uint32_t ball = bodies_[body].ball;
    if (balls_[ball].line.motion == Motion::held) return;
    for (const Touch& touch : touches_)
        if (touch.kind == Kind::ball_ball && (touch.contact.a == body || touch.contact.b == body))
            return crowded_.push_back(ball);
}

template <typename Real>
void EventEngine<Real>::write_crowded(World& world) {
    world.heaped.clear();
    std::sort(crowded_.begin(), crowded_.end());
    crowded_.erase(std::unique(crowded_.begin(), crowded_.end()), crowded_.end());
    for (const std::uint32_t ball : crowded_)
        if (balls_[ball].line.quick > crowding) world.heaped.push_back(world.balls.id[ball]);
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom
