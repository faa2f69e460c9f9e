#include <algorithm>

#include "physics/event/engine.h"

// What touches what at the instant of an impact.
namespace carom {

template <typename Real>
std::uint32_t EventEngine<Real>::body_of(std::uint32_t ball) {
    if (balls_.body(ball) != EventBall<Real>::none) return balls_.body(ball);
    const auto body = static_cast<std::uint32_t>(bodies_.size());
    const BallState<Real> state = state_at(balls_.path(ball), field_, now_);
    bodies_.push_back({.ball = ball,
                       .position = state.position,
                       .fastest = length(state.velocity),
                       .was_resting = balls_[ball].line.motion == Motion::resting});
    impact_bodies_.push_back({state.velocity, balls_.plan(ball).inverse_mass});
    if (world_->model.spin) body_spins_.push_back(spin_at(ball, now_));
    if (world_->model.cloth) body_rolls_.push_back(roll_at(ball, now_));
    balls_.body(ball) = body;
    return body;
}

template <typename Real>
void EventEngine<Real>::add_ball_touch(std::uint32_t body, std::uint32_t other, int across,
                                       int along, bool is_certain) {
    const std::uint32_t ball = bodies_[body].ball;
    const std::uint32_t known = balls_.body(other);
    if (known != EventBall<Real>::none && bodies_[known].is_scanned && !is_certain) return;
    const Vector<Real> shift = torus_shift(across, along);
    const Vector<Real> theirs =
        known != EventBall<Real>::none ? bodies_[known].position : position_of(other);
    const Vector<Real> offset = bodies_[body].position - theirs - shift;
    const Real our_radius = radius(ball);
    const Real their_radius = radius(other);
    const Real reach = our_radius + their_radius;
    const Real away = length(offset);
    Touch touch;
    touch.kind = Kind::ball_ball;
    touch.other = other;
    touch.gap = away - reach;
    touch.contact.a = body;
    touch.contact.b = body_of(other);
    touch.contact.normal =
        away > Real{} ? offset / away : Vector<Real>{ball < other ? Real(1.0) : Real(-1.0), Real{}};
    touch.support = {PathSupport::By::ball, static_cast<std::int8_t>(across),
                     static_cast<std::int8_t>(along), number(world_->balls.id[other])};
    touches_.push_back(touch);
}

// Whether the gap is no more than that of a touch.
template <typename Real>
bool EventEngine<Real>::may_touch(std::uint32_t body, const Near& near) const {
    const Real our_radius = radius(bodies_[body].ball);
    const Real their_radius = radius(near.other);
    const Real small = our_radius < their_radius ? our_radius : their_radius;
    const Real limit = near.reach + small * Real(touching) +
                       Real(16.0) * rounding_at(bodies_[body].position, near.reach);
    return !(length_squared(near.offset) > limit * limit);
}

template <typename Real>
void EventEngine<Real>::add_edge_touch(std::uint32_t body, std::uint32_t capsule, int across,
                                       int along, bool is_certain) {
    const Vec2 shift{torus_.x * across, torus_.y * along};
    const Edge<Real> edge(world_->capsules.shape[capsule], shift);
    const Real size = radius(bodies_[body].ball);
    const auto contact = contact_with(edge, bodies_[body].position, size);
    const Real near = size * Real(touching) +
                      Real(16.0) * rounding_at(bodies_[body].position, size + edge.radius);
    if (!is_certain && contact.gap > near) return;
    if (!is_certain && !is_solid_for(capsule, bodies_[body].position, shift)) return;
    Touch touch;
    touch.kind = Kind::ball_edge;
    touch.other = capsule;
    touch.gap = contact.gap;
    touch.contact.a = body;
    touch.contact.normal = contact.normal;
    touch.support = {PathSupport::By::edge, static_cast<std::int8_t>(across),
                     static_cast<std::int8_t>(along), number(world_->capsules.id[capsule])};
    touches_.push_back(touch);
}

template <typename Real>
void EventEngine<Real>::add_hand_touch(std::uint32_t body, const Hand& hand, bool is_certain) {
    const Real size = radius(bodies_[body].ball);
    const auto contact = contact_with(hand.edge.at(now_), bodies_[body].position, size);
    const Real near =
        size * Real(touching) + Real(16.0) * rounding_at(bodies_[body].position, size);
    if (!is_certain && contact.gap > near) return;
    Touch touch;
    touch.kind = Kind::hand;
    touch.other = hand.capsule;
    touch.is_driven = hand.is_driven;
    touch.gap = contact.gap;
    touch.contact.a = body;
    touch.contact.normal = contact.normal;
    if (now_ < hand.edge.stop) {
        touch.surface_velocity =
            hand.edge.start_velocity +
            (hand.edge.end_velocity - hand.edge.start_velocity) * contact.place;
        touch.contact.surface = dot(contact.normal, touch.surface_velocity);
    }
    touches_.push_back(touch);
}

// Bodies that gravity may press together are not driven apart again and again by approaches that
// are too slow for an impact of their own.
template <typename Real>
Real EventEngine<Real>::pressing_speed(const Touch& touch) const {
    if (!world_->model.gravity || !world_->model.lossy) return Real{};
    Real small = radius(bodies_[touch.contact.a].ball);
    double rise = resting_rise;
    if (touch.kind == Kind::ball_ball) {
        small = std::min(small, radius(touch.other));
        if (!bodies_[touch.contact.a].was_resting && !bodies_[touch.contact.b].was_resting)
            rise = lively_rise;
    }
    return square_root(Real(2.0 * rise) * length(field_.gravity) * small);
}

// All that the body touches at this instant.
template <typename Real>
void EventEngine<Real>::scan(std::uint32_t body) {
    if (bodies_[body].is_scanned) return;
    const std::uint32_t ball = bodies_[body].ball;
    const auto is_first = [&](Kind kind, std::uint32_t other) {
        const Touch& first = touches_.front();
        return first.kind != kind || first.contact.a != body || first.other != other;
    };
    const Vector<Real> position = bodies_[body].position;
    const Real size = radius(ball);
    const EventBall<Real>* const balls = balls_.data();
    const bool is_coasting = !world_->model.gravity && !field_.has_drag;
    const bool wraps = world_->model.wrap.has_value();
    // The contact that the event is about is there already.
    const Touch& first = touches_.front();
    const std::uint32_t first_ball = bodies_[first.contact.a].ball;
    const std::uint32_t second_ball =
        select(first.other == ball, first_ball, EventBall<Real>::none);
    const std::uint32_t partner = first.kind != Kind::ball_ball
                                      ? EventBall<Real>::none
                                      : select(first.contact.a == body, first.other, second_ball);
    // Nearly all of the others are further away than this, which is further than any that may
    // touch.
    const Real slack = Real(16.0) * rounding_at(position, Real{});
    const std::size_t first_near = near_count_;
    std::size_t count = first_near;
    std::size_t close_count = 0;
    for_each_ball_near(ball, [&, balls, now = now_](std::uint32_t other, int across, int along) {
        if (count == near_.size()) {
            near_.resize(2 * count + 16);
            which_near_.resize(std::max(which_near_.size(), near_.size()));
        }
        const EventLine<Real>& path = balls[other].line;
        Vector<Real> offset = position - (is_coasting && path.motion == Motion::free
                                              ? path.position + path.velocity * (now - path.time)
                                              : position_of(other));
        if (wraps) offset = offset - torus_shift(across, along);
        const Real reach = size + balls[other].radius;
        near_[count] = {.offset = offset,
                        .reach = reach,
                        .other = other,
                        .across = static_cast<std::int8_t>(across),
                        .along = static_cast<std::int8_t>(along)};
        const Real rough = reach * Real(1.0 + 4.0 * touching) + slack;
        const bool is_far = length_squared(offset) > rough * rough;
        which_near_[close_count] = static_cast<std::uint32_t>(count++);
        close_count += static_cast<std::size_t>(static_cast<int>(!is_far) &
                                                static_cast<int>(other != partner));
    });
    near_count_ = count;
    bodies_[body].first_near = static_cast<std::uint32_t>(first_near);
    bodies_[body].near = static_cast<std::uint32_t>(count - first_near);
    touching_.clear();
    for (std::size_t i = 0; i < close_count; ++i) {
        const Near& near = near_[which_near_[i]];
        if (may_touch(body, near) && balls_meet(ball, near.other))
            touching_.push_back({static_cast<int>(near.other), near.across, near.along});
    }
    // By number: where the cells are must not show, not even in rounding.
    std::sort(touching_.begin(), touching_.end());
    for (const auto& [other, across, along] : touching_)
        add_ball_touch(body, static_cast<std::uint32_t>(other), across, along, false);
    for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2, int across, int along) {
        if (is_first(Kind::ball_edge, capsule)) add_edge_touch(body, capsule, across, along, false);
    });
    for (const Hand& hand : hands_)
        if (ball_meets(ball, hand.capsule) && is_first(Kind::hand, hand.capsule))
            add_hand_touch(body, hand, false);
    bodies_[body].is_scanned = true;
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom
