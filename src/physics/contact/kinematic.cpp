#include <algorithm>

#include "geometry/closest.h"
#include "physics/contact/solver.h"

// Hands in the solver `contact`: how far they go in a substep, and what holds them back.
namespace carom {

// A hand that was held back in this tick does not make up for it before the tick ends.
void ContactSolver::take_hands(const World& world, double share_of_way) {
    was_held_back_.resize(hands_.size(), 0);
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        Hand& hand = hands_[i];
        hand.share = 1.0;
        hand.stopped_at = -1.0;
        hand.version = 0;
        const double per_second =
            was_held_back_[i] ? 1.0 / world.tick_length() : share_of_way / duration_;
        if (hand.is_ball) {
            Vec2 way = world.held_balls[hand.held].target - position_[hand.index];
            if (wraps_) way = nearest_image(way, torus_);
            hand.start_velocity = hand.end_velocity = way * per_second;
            continue;
        }
        const HeldCapsule& held = world.held_capsules[hand.held];
        const Capsule& shape = world.capsules.shape[hand.index];
        hand.start_velocity = (held.start_target - shape.start) * per_second;
        hand.end_velocity = (held.end_target - shape.end) * per_second;
    }
}

void ContactSolver::move_hands(World& world) {
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        const Hand& hand = hands_[i];
        if (hand.share < 1.0 || hand.stopped_at >= 0.0) was_held_back_[i] = 1;
        if (!hand.is_ball) world.capsules.shape[hand.index] = shape_of(world, hand, duration_);
    }
}

ContactSolver::Hand* ContactSolver::hand_of(std::uint32_t capsule) {
    for (Hand& hand : hands_)
        if (!hand.is_ball && hand.index == capsule) return &hand;
    return nullptr;
}

const ContactSolver::Hand* ContactSolver::hand_of(std::uint32_t capsule) const {
    return const_cast<ContactSolver*>(this)->hand_of(capsule);
}

ContactSolver::Hand* ContactSolver::hand_of_body(std::uint32_t body) {
    for (Hand& hand : hands_)
        if (hand.is_ball && hand.index == body) return &hand;
    return nullptr;
}

// Pre: the pair is by hand.
ContactSolver::Hand& ContactSolver::hand_of(const Pair& pair) {
    if (pair.b > still_) return *hand_of(pair.edge);
    return *hand_of_body(is_held_body(pair.a) ? pair.a : pair.b);
}

Vec2 ContactSolver::surface_velocity(const Hand& hand, const Capsule& shape, Vec2 point) const {
    if (hand.stopped_at >= 0.0) return {};
    const double place = closest_parameter(shape.start, shape.end, point);
    return (hand.start_velocity + (hand.end_velocity - hand.start_velocity) * place) * hand.share;
}

Capsule ContactSolver::shape_of(const World& world, const Hand& hand, double now) const {
    Capsule shape = world.capsules.shape[hand.index];
    const double moved =
        (hand.stopped_at >= 0.0 ? std::min(now, hand.stopped_at) : now) * hand.share;
    shape.start += hand.start_velocity * moved;
    shape.end += hand.end_velocity * moved;
    return shape;
}

// What hands push against other hands presses back on them: pressed again, from the top down and
// from the bottom up by turns, until no hand is held back any more. So a ball that is jammed keeps
// no speed that the hands have not.
void ContactSolver::hold_hands_back(bool spin) {
    for (int round = 0; round < most_holds && !hand_pairs_.empty() && shorten_hands(); ++round)
        press(spin, round % 2 == 0);
}

// A hand goes no further into a ball than a tenth of its radius: beyond, it waits for the ball.
// Whether one had to.
bool ContactSolver::shorten_hands() {
    for (Hand& hand : hands_)
        hand.shortened = 1.0;
    bool is_any = false;
    for (const std::uint32_t p : hand_pairs_) {
        const Pair& pair = pairs_[p];
        if (pair.mass == 0.0) continue;
        const bool by_a = pair.b < still_ && is_held_body(pair.a);
        const std::uint32_t ball = by_a ? pair.b : pair.a;
        const Vec2 normal = by_a ? -pair.normal : pair.normal;
        const double surface = dot(mover_[by_a ? pair.a : pair.b].velocity, normal);
        const double speed = dot(mover_[ball].velocity, normal);
        const double room = std::max(0.0, pair.gap + 0.1 * radius_[ball]) / duration_;
        if (!(surface > 0.0) || surface - speed <= room) continue;
        Hand& hand = hand_of(pair);
        hand.shortened = std::min(hand.shortened, std::max(0.0, (speed + room) / surface));
        is_any = true;
    }
    for (Hand& hand : hands_)
        hand.share *= hand.shortened;
    for (const std::uint32_t p : hand_pairs_) {
        const Pair& pair = pairs_[p];
        if (pair.b > still_) mover_[pair.b].velocity *= hand_of(pair.edge)->shortened;
    }
    return is_any;
}

// Balls that hands press on and that do not give way, and what touches them, keep no more speed
// than they have gone in the substep: else they would have that of the hands, which want to be far
// away.
void ContactSolver::settle_jams() {
    jammed_.clear();
    is_jammed_.assign(still_, 0);
    const auto jam = [&](const Pair& pair, std::uint32_t body) {
        const double smaller =
            pair.b < still_ ? std::min(radius_[pair.a], radius_[pair.b]) : radius_[pair.a];
        if (pair.gap > 0.1 * smaller || is_held_body(body) || is_jammed_[body]) return;
        is_jammed_[body] = 1;
        jammed_.push_back(body);
    };
    for (const std::uint32_t p : hand_pairs_) {
        const Pair& pair = pairs_[p];
        const Hand& hand = hand_of(pair);
        if (hand.share == 1.0 && hand.stopped_at < 0.0) continue;
        jam(pair, is_held_body(pair.a) ? pair.b : pair.a);
    }
    if (jammed_.empty()) return;
    if (!has_pairs_of_bodies_) list_pairs_of_bodies();
    for (std::size_t next = 0; next < jammed_.size(); ++next) {
        const std::uint32_t body = jammed_[next];
        for (std::uint32_t k = pairs_begin_[body]; k < pairs_begin_[body + 1]; ++k) {
            const Pair& pair = pairs_[pairs_of_[k]];
            if (pair.b < still_) jam(pair, pair.a == body ? pair.b : pair.a);
        }
    }
    for (const std::uint32_t body : jammed_)
        mover_[body].velocity = limited(mover_[body].velocity, length(way_[body]) / duration_);
}

// Where a ball that stands is in its way, the hand stops for the substep.
void ContactSolver::stop_hand(const World& world, std::uint32_t capsule, double now) {
    Hand& hand = *hand_of(capsule);
    hand.stopped_at = now;
    ++hand.version;
    for (const std::uint32_t p : hand_pairs_)
        if (pairs_[p].edge == capsule) predict(world, pairs_[p].a, now);
}

}  // namespace carom
