#include <algorithm>
#include <tuple>

#include "physics/contact/path.h"
#include "physics/contact/solver.h"
#include "physics/laws/bounce.h"
#include "physics/memory/prefetch.h"

// Impacts within a substep of the solver `contact`: found along the paths of the balls, and dealt
// with in the order (time, kind, lower number, higher number).
namespace carom {

// Which pairs may meet in this substep. How far two bodies close is at most what they close along
// the line between them at first, for the distance along straight paths is convex.
void ContactSolver::find_hits() {
    hits_.clear();
    const auto shrinks = [&](const Pair& pair) {
        if (pair.b <= still_) return -dot(way_[pair.a] - way_[pair.b], pair.normal);
        const Hand& hand = *hand_of(pair.edge);
        const double fastest =
            std::max(length(hand.start_velocity), length(hand.end_velocity)) * hand.share;
        return length(way_[pair.a]) + fastest * duration_;
    };
    for (const std::uint32_t p : flying_)
        if (shrinks(pairs_[p]) > pairs_[p].gap) hits_.push_back(p);
    // Others only where pressed pairs have pushed somebody far, or lie deep in one another.
    if (2.0 * most_push_ <= guard_ && deepest_ >= -0.25 * smallest_) return;
    for (std::uint32_t p = 0; p < pairs_.size(); ++p) {
        const Pair& pair = pairs_[p];
        if (pair.state == State::flying) continue;
        const double deep = pair.state == State::pressed ? core(pair) : 0.0;
        if (shrinks(pair) > pair.gap + deep) hits_.push_back(p);
    }
}

void ContactSolver::run_impacts(World& world, std::vector<Contact>& contacts) {
    begin_paths();
    queue_.clear();
    for (const std::uint32_t stray : strays_) {
        begin_path(stray);
        end_path_at_border(stray, 0.0);
    }
    for (std::size_t hit = 0; hit < hits_.size(); ++hit) {
        if (still_ >= too_many_to_cache) look_ahead(hit);
        const std::uint32_t body = pairs_[hits_[hit]].a;
        begin_path(body);
        if (!path_of(body).is_surrounded) predict(world, body, 0.0);
    }
    while (!queue_.empty()) {
        std::pop_heap(queue_.begin(), queue_.end(),
                      [](const Event& a, const Event& b) { return is_earlier(b, a); });
        const Event event = queue_.back();
        queue_.pop_back();
        if (event.body_version != path_of(event.body).version) continue;
        if (event.kind == Event::stands) {
            stand(event.body, event.time);
            predict(world, event.body, event.time);
        } else if (is_void(event)) {
            predict(world, event.body, event.time);
        } else {
            collide(world, event, contacts);
        }
    }
    finish_paths(world);
}

// Fetches from memory what the hits to come are going to need: first the pair, then its bodies,
// then the pairs of these, then their bodies.
void ContactSolver::look_ahead(std::size_t hit) const {
    const auto coming = [&](std::size_t by) -> const Pair* {
        return hit + by < hits_.size() ? &pairs_[hits_[hit + by]] : nullptr;
    };
    const auto fetch_body = [&](std::uint32_t body) {
        fetch_early(&place_of_path_[body]);
        fetch_early(&position_[body]);
        fetch_early(&way_[body]);
        fetch_early(&before_[body]);
        fetch_early(&mover_[body]);
    };
    const auto for_each_pair = [&](const Pair& pair, auto&& visit) {
        for (std::uint32_t k = pairs_begin_[pair.a]; k < pairs_begin_[pair.a + 1]; ++k)
            visit(pairs_[pairs_of_[k]]);
    };
    if (hit + 24 < hits_.size()) fetch_early(&pairs_[hits_[hit + 24]]);
    if (const Pair* const pair = coming(16)) {
        fetch_early(&pairs_begin_[pair->a]);
        fetch_body(pair->a);
        if (pair->b < still_) fetch_body(pair->b);
    }
    if (const Pair* const pair = coming(12)) fetch_early(&pairs_of_[pairs_begin_[pair->a]]);
    if (const Pair* const pair = coming(8))
        for_each_pair(*pair, [&](const Pair& near) { fetch_early(&near); });
    if (const Pair* const pair = coming(4))
        for_each_pair(*pair, [&](const Pair& near) {
            const std::uint32_t other = near.a == pair->a ? near.b : near.a;
            if (other < still_) fetch_body(other);
        });
}

bool ContactSolver::is_void(const Event& event) const {
    const Pair& pair = pairs_[event.pair];
    if (pair.b > still_) return hand_of(pair.edge)->version != event.other_version;
    if (pair.b == still_) return false;
    const std::uint32_t other = pair.a == event.body ? pair.b : pair.a;
    return path_of(other).version != event.other_version;
}

// The edge of a pair, as the ball sees it.
Capsule ContactSolver::edge_at(const World& world, const Pair& pair, double now) const {
    if (pair.b > still_) return shape_of(world, *hand_of(pair.edge), now);
    Capsule shape = world.capsules.shape[pair.edge];
    if (wraps_) {
        const Vec2 shift{pair.across * torus_.x, pair.along * torus_.y};
        shape.start += shift;
        shape.end += shift;
    }
    return shape;
}

// When the pair meets from now on. Pressed pairs that rest on one another meet where their cores
// do; and so do those that would not bounce, while they are no deeper in one another than a hand
// goes: what the rounds have left of their approach is for the rounds of the next substep. Impact
// by impact a heap that falls together would never be done.
std::optional<double> ContactSolver::meeting(const World& world, const Pair& pair,
                                             double now) const {
    const Path& path = path_of(pair.a);
    const double left = duration_ - now;
    const Vec2 at = chord_position(pair.a, now);
    const Vec2 chord = now < path.end ? path.chord : Vec2{};
    const auto is_soft = [&](Vec2 other) {
        if (pair.settled) return true;
        if (pair.state != State::pressed) return false;
        if ((!pair.bounces || is_bedded(pair)) && pair.gap > -0.2 * core(pair)) return true;
        return -dot(velocity_at(world, pair.a, now) - other, pair.normal) <= resting_speed_;
    };
    double radius = radius_[pair.a];
    std::optional<Impact> impact;
    if (pair.b < still_) {
        const Path& other = path_of(pair.b);
        Vec2 offset = at - chord_position(pair.b, now);
        if (wraps_) offset = nearest_image(offset, torus_);
        const Vec2 relative = chord - (now < other.end ? other.chord : Vec2{});
        if (stays_apart(offset, relative, radius + radius_[pair.b], left)) return std::nullopt;
        if (is_soft(velocity_at(world, pair.b, now))) radius -= core(pair);
        const double reach = radius + radius_[pair.b];
        impact = first_impact(Disc{offset, reach}, relative, Disc{{}, 0.0}, left);
    } else if (pair.b == still_) {
        const Capsule shape = edge_at(world, pair, now);
        if (is_soft({})) radius -= core(pair);
        impact = first_impact(Disc{at, radius}, chord, shape, left);
        if (impact && world.model.one_way &&
            !is_on_solid_side(shape, world.capsules.side[pair.edge], at + chord * impact->time))
            return std::nullopt;
    } else {
        const Hand& hand = *hand_of(pair.edge);
        const Capsule shape = edge_at(world, pair, now);
        if (is_soft(mover_[pair.b].velocity)) radius -= core(pair);
        const double share = hand.stopped_at >= 0.0 ? 0.0 : hand.share;
        impact = first_impact(Disc{at, radius}, chord, shape, hand.start_velocity * share,
                              hand.end_velocity * share, left);
    }
    if (!impact) return std::nullopt;
    return now + impact->time;
}

// Puts the first impact of a body from now on into the queue.
void ContactSolver::predict(const World& world, std::uint32_t body, double now) {
    begin_paths_around(body);
    const Path& path = path_of(body);
    std::optional<Event> best;
    for (std::uint32_t k = pairs_begin_[body]; k < pairs_begin_[body + 1]; ++k) {
        const std::uint32_t p = pairs_of_[k];
        const Pair& pair = pairs_[p];
        const auto time = meeting(world, pair, now);
        if (!time || !(*time < duration_)) continue;
        const bool on_ball = pair.b < still_;
        const std::uint32_t other = pair.a == body ? pair.b : pair.a;
        const Event event{
            .time = *time,
            .kind = on_ball ? Event::ball : Event::edge,
            .low = ball_[pair.a],
            .high = on_ball ? ball_[pair.b] : pair.edge,
            .body = body,
            .pair = p,
            .body_version = path.version,
            .other_version = on_ball ? path_of(other).version
                                     : (pair.b > still_ ? hand_of(pair.edge)->version : 0)};
        if (!best || is_earlier(event, *best)) best = event;
    }
    if (best) push(*best);
}

bool ContactSolver::is_earlier(const Event& a, const Event& b) {
    if (a.time != b.time) return a.time < b.time;
    return std::tuple(a.kind, a.low, a.high, a.body) < std::tuple(b.kind, b.low, b.high, b.body);
}

void ContactSolver::push(const Event& event) {
    queue_.push_back(event);
    std::push_heap(queue_.begin(), queue_.end(),
                   [](const Event& a, const Event& b) { return is_earlier(b, a); });
}

}  // namespace carom
