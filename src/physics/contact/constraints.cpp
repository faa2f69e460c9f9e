#include <algorithm>

#include "geometry/closest.h"
#include "physics/contact/solver.h"
#include "physics/laws/bounce.h"

// Pressed pairs: which pairs those are in a substep, and the impulses that hold them apart.
namespace carom {

// The way from b to a, and the gap between them.
template <Terms terms>
inline void ContactSolver::measure(const World& world, Pair& pair) {
    Vec2 offset;
    double reach = radius_[pair.a];
    if (pair.edge == NearPair::no_edge) {
        offset = position_[pair.a] - position_[pair.b];
        if (terms.wrap()) offset = nearest_image(offset, torus_);
        reach += radius_[pair.b];
    } else {
        Vec2 at = position_[pair.a];
        if (terms.wrap()) at -= Vec2{pair.across * torus_.x, pair.along * torus_.y};
        const Capsule& shape = world.capsules.shape[pair.edge];
        offset = at - closest_point(shape.start, shape.end, at);
        reach += shape.radius;
        if (terms.special() && pair.b > still_)
            before_[pair.b] = mover_[pair.b].velocity =
                surface_velocity(*hand_of(pair.edge), shape, at);
    }
    const double away = length(offset);
    pair.gap = away - reach;
    if (away > 1e-150)
        pair.normal = offset * (1.0 / away);
    else
        pair.normal = direction(-gravity_, {0.0, 1.0});
}

// Whether the hand pushes the ball on faster than it would bounce off a still one.
bool ContactSolver::is_pushed(const World& world, const Pair& pair, double approach) const {
    if (pair.b > still_ && hand_of(pair.edge)->is_driven) return false;
    const bool by_a = pair.b < still_ && is_held_body(pair.a);
    const std::uint32_t hand = by_a ? pair.a : pair.b;
    const std::uint32_t ball = by_a ? pair.b : pair.a;
    const Vec2 normal = by_a ? -pair.normal : pair.normal;
    const double surface = dot(before_[hand], normal);
    if (!(surface > 0.0)) return false;
    const double speed = dot(before_[ball], normal);
    return -restitution_of(world, pair, std::max(0.0, approach)) * speed <= surface;
}

// On each body, at the end of the last substep: the impulses say so.
void ContactSolver::count_presses() {
    presses_on_.clear();
    if (!any_damped_ || gravity_ == Vec2{}) return;
    presses_on_.assign(mover_.size(), 0);
    const auto count = [&](const Pair& pair) {
        if (!(pair.impulse > 0.0)) return;
        for (const std::uint32_t body : {pair.a, pair.b})
            if (presses_on_[body] < bedded) ++presses_on_[body];
    };
    if (is_loaded_anew_)
        for (const Pair& pair : pairs_)
            count(pair);
    else
        for (const std::uint32_t p : pressed_)
            count(pairs_[p]);
}

// Whether the two have no room to bounce.
bool ContactSolver::is_bedded(const Pair& pair) const {
    if (!pair.damped || presses_on_.empty()) return false;
    return presses_on_[pair.a] >= bedded && (pair.b >= still_ || presses_on_[pair.b] >= bedded);
}

template <Terms terms>
inline ContactSolver::State ContactSolver::state_of(const World& world, const Pair& pair) const {
    Vec2 relative = before_[pair.a] - before_[pair.b];
    const Vec2 without_fall = relative;
    if (mover_[pair.b].inverse_mass == 0.0) relative += gravity_ * duration_;
    if (terms.special() && is_held_body(pair.a)) relative -= gravity_ * duration_;
    const double approach = -dot(relative, pair.normal);
    if (pair.gap - approach * duration_ > guard_) return State::idle;
    if (terms.special() && pair.mass == 0.0) return approach > 0.0 ? State::flying : State::idle;
    const double radius =
        pair.b < still_ ? std::min(radius_[pair.a], radius_[pair.b]) : radius_[pair.a];
    const double most = 0.25 * radius / duration_;
    const bool pushed = terms.special() && pair.by_hand && is_pushed(world, pair, approach);
    // A hand that touches goes on pushing, however far its target: it can be held back.
    const bool is_fast = length_squared(relative) > most * most && !(pushed && pair.gap <= 0.0);
    if (approach > 0.0 && is_fast) return State::flying;
    if (pair.bounces && !pushed) {
        if (resting_speed_ == 0.0) return approach > 0.0 ? State::flying : State::idle;
        // Bodies that overlap meet at once, before gravity has made the approach any faster.
        const bool is_held = pair.gap < 0.0 && (pair.impulse > 0.0 ||
                                                -dot(without_fall, pair.normal) < resting_speed_);
        if (approach >= resting_speed_ && !is_held && !is_bedded(pair)) return State::flying;
    }
    if (terms.special() && world.model.one_way && pair.edge != NearPair::no_edge) {
        const bool engaged = pair.impulse > 0.0 || pair.gap > -0.5 * radius;
        if (!engaged || !is_on_solid_side(world.capsules.shape[pair.edge],
                                          world.capsules.side[pair.edge], position_[pair.a]))
            return State::idle;
    }
    return State::pressed;
}

template <Terms terms>
void ContactSolver::sort_pairs(const World& world) {
    pressed_.clear();
    new_.clear();
    flying_.clear();
    any_uneven_ = false;
    deepest_ = 0.0;
    for (std::uint32_t p = 0; p < pairs_.size(); ++p) {
        Pair& pair = pairs_[p];
        measure<terms>(world, pair);
        pair.state = state_of<terms>(world, pair);
        pair.settled = false;
        if (pair.state != State::pressed) {
            pair.impulse = pair.rub = 0.0;
            if (pair.state == State::flying) flying_.push_back(p);
            continue;
        }
        pressed_.push_back(p);
        any_uneven_ = any_uneven_ || is_uneven(pair);
        deepest_ = std::min(deepest_, pair.gap);
    }
}

void ContactSolver::prepare(const World& world, Terms terms) {
    with_terms(terms, [&]<Terms set>() { sort_pairs<set>(world); });
}

bool ContactSolver::is_uneven(const Pair& pair) const {
    const double a = mover_[pair.a].inverse_mass;
    const double b = mover_[pair.b].inverse_mass;
    return a > 0.0 && b > 0.0 && std::max(a, b) >= uneven * std::min(a, b);
}

}  // namespace carom
