#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/closest.h"
#include "physics/bounce.h"
#include "physics/contact_solver.h"
#include "physics/fetch.h"

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

void ContactSolver::begin_paths() {
    if (!has_pairs_of_bodies_) list_pairs_of_bodies();
    paths_.clear();
    place_of_path_.resize(still_, none);
    for (const Hand& hand : hands_)
        if (hand.is_ball) begin_path(hand.index);
}

// Only balls that could meet something, and those that these could meet, need paths.
void ContactSolver::begin_path(std::uint32_t body) {
    if (place_of_path_[body] != none) return;
    place_of_path_[body] = static_cast<std::uint32_t>(paths_.size());
    const Vec2 before = before_[body];
    const Vec2 after = mover_[body].velocity;
    Path& path = paths_.emplace_back();
    path.body = body;
    path.position = position_[body];
    path.chord = way_[body] / duration_;
    path.rim = rim_before_.empty() ? 0.0 : rim_before_[body];
    path.turn = (mover_[body].rim - path.rim) / duration_;
    path.end = duration_;
    if (is_held_body(body)) {
        path.velocity = path.chord;
        return;
    }
    path.velocity = before;
    path.pull = (after - before) / duration_;
    path.free = after == before * flight_.decay + gravity_ * flight_.velocity_per_gravity;
}

// The paths of the body and of all balls in its pairs. Whoever holds a path finds it elsewhere
// then.
void ContactSolver::begin_paths_around(std::uint32_t body) {
    begin_path(body);
    if (path_of(body).is_surrounded) return;
    path_of(body).is_surrounded = true;
    for (std::uint32_t k = pairs_begin_[body]; k < pairs_begin_[body + 1]; ++k) {
        const Pair& pair = pairs_[pairs_of_[k]];
        begin_path(pair.a);
        if (pair.b < still_) begin_path(pair.b);
    }
}

// Friction may take back what it has given to both, and no more: else it would speed up slip. And a
// body that waits has not felt what pushed the other one away from it: where the two part faster
// than what rests does, that would push it again in the next substep. Where they do not, it is a
// load that one of them still carries.
void ContactSolver::forget_what_was_not_given(const World& world) {
    struct Share {
        double rub = 1.0;
        double impulse = 1.0;
    };
    const auto given = [&](std::uint32_t body) -> Share {
        if (body >= still_ || place_of_path_[body] == none) return {};
        const Path& path = path_of(body);
        return {.rub = path.given, .impulse = path.stands ? path.given : 1.0};
    };
    const auto velocity_then = [&](std::uint32_t body) {
        const bool has_path = body < still_ && place_of_path_[body] != none;
        return has_path ? velocity_at(world, body, duration_) : mover_[body].velocity;
    };
    for (std::size_t k = 0; k < presses_used_; ++k) {
        Presses& presses = presses_[k];
        for (const int which : {0, 1}) {
            const Share a = given(presses.a[which]);
            const Share b = given(presses.b[which]);
            const double impulse = std::min(a.impulse, b.impulse);
            const Vec2 normal{presses.normal_x[which], presses.normal_y[which]};
            if (impulse < 1.0 &&
                dot(velocity_then(presses.a[which]) - velocity_then(presses.b[which]), normal) >
                    most_throw * resting_speed_)
                presses.impulse[which] *= impulse;
            presses.rub[which] *= std::min(a.rub, b.rub);
        }
    }
}

void ContactSolver::finish_paths(const World& world) {
    forget_what_was_not_given(world);
    for (std::uint32_t i = 0; i < still_; ++i)
        if (place_of_path_[i] == none || path_of(i).version == 0) position_[i] += way_[i];
    for (const Path& path : paths_) {
        const std::uint32_t body = path.body;
        if (path.version > 0) {
            const Vec2 after = position_at(world, body, duration_);
            way_[body] = after - position_[body];
            position_[body] = after;
            mover_[body].velocity = velocity_at(world, body, duration_);
            mover_[body].rim = rim_at(body, duration_);
        }
        if (is_held_body(body)) mover_[body].velocity = path.chord;
        place_of_path_[body] = none;
    }
    if (!world.model.speed_limit) return;
    for (std::uint32_t i = 0; i < still_; ++i)
        mover_[i].velocity = limited(mover_[i].velocity, *world.model.speed_limit);
}

// From the near pairs, which take less memory than what has become of them.
void ContactSolver::list_pairs_of_bodies() {
    has_pairs_of_bodies_ = true;
    pairs_begin_.assign(still_ + 2, 0);
    const std::vector<NearPair>& near = near_.pairs();
    for (const NearPair& pair : near) {
        ++pairs_begin_[pair.a + 2];
        if (pair.b < still_) ++pairs_begin_[pair.b + 2];
    }
    for (std::size_t i = 2; i < pairs_begin_.size(); ++i)
        pairs_begin_[i] += pairs_begin_[i - 1];
    pairs_of_.resize(pairs_begin_.back());
    for (std::uint32_t p = 0; p < near.size(); ++p) {
        const NearPair& pair = near[turn_.empty() ? p : turn_[p]];
        pairs_of_[pairs_begin_[pair.a + 1]++] = p;
        if (pair.b < still_) pairs_of_[pairs_begin_[pair.b + 1]++] = p;
    }
}

Vec2 ContactSolver::chord_position(std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    return path.position + path.chord * (std::min(now, path.end) - path.time);
}

Vec2 ContactSolver::position_at(const World& world, std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    const double since = std::min(now, path.end) - path.time;
    if (!path.free) return path.position + path.chord * since;
    return path.position + travel(flight_over(world.model.drag, since), path.velocity, gravity_);
}

Vec2 ContactSolver::velocity_at(const World& world, std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    const double since = std::min(now, path.end) - path.time;
    if (!path.free) return path.velocity + path.pull * since;
    return velocity_after(flight_over(world.model.drag, since), path.velocity, gravity_);
}

double ContactSolver::rim_at(std::uint32_t body, double now) const {
    const Path& path = path_of(body);
    return path.rim + path.turn * (std::min(now, path.end) - path.time);
}

// The path ends that the ball was on at the start of the substep.
void ContactSolver::leave(Path& path, double now) const {
    if (path.version == 0 && !path.free) path.given = std::min(now, path.end) / duration_;
}

// From now on the ball flies freely from where it is, at first at `velocity`, and turns evenly.
void ContactSolver::take_path(const World& world, std::uint32_t body, double now, Vec2 velocity,
                              double rim) {
    Path& path = path_of(body);
    leave(path, now);
    path.position = position_at(world, body, now);
    path.time = now;
    path.velocity = velocity;
    path.pull = {};
    path.rim = rim;
    path.turn = 0.0;
    ++path.version;
    if (path.stands) return;
    if (++path.impacts >= most_impacts) {
        stand(body, now);
        return;
    }
    if (is_held_body(body)) {
        path.chord = velocity;
        return;
    }
    const double left = duration_ - now;
    path.free = true;
    path.chord = left > 0.0 ? travel(flight_over(world.model.drag, left), velocity, gravity_) / left
                            : velocity;
    path.end = duration_;
    end_path_at_border(body, now);
}

// What hands push to and fro comes to lie still.
void ContactSolver::count_push(std::uint32_t body, double now) {
    Path& path = path_of(body);
    if (++path.pushes < most_pushes) return;
    if (!path.stands) stand(body, now);
    path.velocity = {};
}

// Where the path leads out of the region in which the ball was compared with others, it ends there.
void ContactSolver::end_path_at_border(std::uint32_t body, double now) {
    Path& path = path_of(body);
    const Vec2 away = path.position - home_[body];
    const double room = margin_[body] * margin_[body];
    const double left = duration_ - now;
    if (length_squared(away + path.chord * left) <= room) return;
    // |away + chord t|^2 = room
    const double a = length_squared(path.chord);
    const double b = dot(away, path.chord);
    const double c = std::min(0.0, length_squared(away) - room);
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    double time = 0.0;
    if (b > 0.0)
        time = -c / (b + root);
    else if (a > 0.0)
        time = (root - b) / a;
    path.end = std::clamp(now + time, now, duration_);
    push({.time = path.end,
          .kind = Event::stands,
          .low = ball_[body],
          .high = ball_[body],
          .body = body,
          .body_version = path.version});
}

void ContactSolver::stand(std::uint32_t body, double now) {
    Path& path = path_of(body);
    leave(path, now);
    const double since = std::min(now, path.end) - path.time;
    const Flight flight = flight_over(drag_, since);
    if (path.free) {
        path.position += travel(flight, path.velocity, gravity_);
        path.velocity = velocity_after(flight, path.velocity, gravity_);
    } else {
        path.position += path.chord * since;
        path.velocity += path.pull * since;
    }
    path.rim += path.turn * since;
    path.chord = path.pull = {};
    path.turn = 0.0;
    path.time = now;
    path.end = duration_;
    path.free = false;
    path.stands = true;
    ++path.version;
}

// What runs into a body that stands, or into an edge, though it comes no faster, would meet it
// again at once and for ever: it waits there. `normal` points from there to the body.
void ContactSolver::wait_behind(std::uint32_t other, std::uint32_t body, Vec2 normal, double now) {
    if (path_of(other).stands) wait_at(body, normal, now);
}

void ContactSolver::wait_at(std::uint32_t body, Vec2 normal, double now) {
    if (path_of(body).stands || is_held_body(body)) return;
    if (dot(path_of(body).chord, normal) < 0.0) stand(body, now);
}

double ContactSolver::restitution_of(const World& world, const Pair& pair, double approach) const {
    if (!world.model.lossy) return 1.0;
    if (pair.edge != NearPair::no_edge)
        return restitution_at(world.materials[world.capsules.material[pair.edge]], approach);
    return std::min(world.balls.restitution[ball_[pair.a]], world.balls.restitution[ball_[pair.b]]);
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

void ContactSolver::collide(World& world, const Event& event, std::vector<Contact>& contacts) {
    Pair& pair = pairs_[event.pair];
    const std::uint32_t a = pair.a;
    const std::uint32_t b = pair.b;
    const double now = event.time;
    if (b > still_ && path_of(a).stands) {
        stop_hand(world, pair.edge, now);
        return;
    }
    const auto contact =
        b < still_ ? collide_balls(world, pair, now) : collide_edge(world, pair, now);
    if (contact) {
        pair.is_new = false;
        contacts.push_back(*contact);
        contacts.back().time += start_time_;
    }
    predict(world, a, now);
    if (b < still_) predict(world, b, now);
}

std::optional<Contact> ContactSolver::collide_balls(World& world, Pair& pair, double now) {
    const std::uint32_t a = pair.a;
    const std::uint32_t b = pair.b;
    Vec2 offset = position_at(world, a, now) - position_at(world, b, now);
    if (wraps_) offset = nearest_image(offset, torus_);
    const Vec2 normal = direction(offset, pair.normal);
    Vec2 velocity_a = velocity_at(world, a, now);
    Vec2 velocity_b = velocity_at(world, b, now);
    double rim_a = rim_at(a, now);
    double rim_b = rim_at(b, now);
    const double approach = -dot(velocity_a - velocity_b, normal);
    const double rounding = noise * (length(velocity_a) + length(velocity_b));
    const bool bounces =
        approach > std::max(rounding, resting_speed_) && !pair.settled && !is_bedded(pair);
    const bool again = pair.settled;
    pair.settled = again || !bounces;
    const double restitution = bounces ? restitution_of(world, pair, approach) : 0.0;
    Exchange done{0.0, approach};
    if (is_held_body(a))
        done = bounce_off(velocity_b, mover_[b].inverse_mass, -normal, dot(velocity_a, -normal),
                          restitution);
    else if (is_held_body(b))
        done = bounce_off(velocity_a, mover_[a].inverse_mass, normal, dot(velocity_b, normal),
                          restitution);
    else if (approach > 0.0)
        done = bounce(velocity_a, mover_[a].inverse_mass, velocity_b, mover_[b].inverse_mass,
                      normal, restitution);
    if (world.model.spin)
        rub(velocity_a, {rim_a, 1.0}, mover_[a].inverse_mass, velocity_b, {rim_b, 1.0},
            mover_[b].inverse_mass, normal, done.impulse, {pair.friction, *world.model.spin});
    take_path(world, a, now, velocity_a, rim_a);
    take_path(world, b, now, velocity_b, rim_b);
    if (is_held_body(a)) count_push(b, now);
    if (is_held_body(b)) count_push(a, now);
    if (!(approach > rounding)) {
        if (again) {
            wait_behind(a, b, -normal, now);
            wait_behind(b, a, normal, now);
        }
        return std::nullopt;
    }
    return Contact{.time = now,
                   .kind = ContactKind::ball_ball,
                   .a = ball_[a],
                   .b = ball_[b],
                   .point = path_of(b).position + normal * radius_[b],
                   .normal = normal,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

std::optional<Contact> ContactSolver::collide_edge(World& world, Pair& pair, double now) {
    const std::uint32_t a = pair.a;
    const Vec2 position = position_at(world, a, now);
    const Capsule shape = edge_at(world, pair, now);
    const Vec2 normal =
        direction(position - closest_point(shape.start, shape.end, position), pair.normal);
    const Hand* const hand = pair.b > still_ ? hand_of(pair.edge) : nullptr;
    const Vec2 surface = hand ? surface_velocity(*hand, shape, position) : Vec2{};
    const bool is_driven = hand && hand->is_driven;
    const double along_normal = dot(surface, normal);
    Vec2 velocity = velocity_at(world, a, now);
    double rim = rim_at(a, now);
    const double approach = along_normal - dot(velocity, normal);
    const double rounding = noise * (length(velocity) + length(surface));
    if (is_held_body(a)) {
        // A held ball goes no further than the edge lets it.
        pair.settled = true;
        take_path(world, a, now, velocity + normal * std::max(0.0, approach), rim);
        return std::nullopt;
    }
    const double least = std::max(rounding, along_normal > 0.0 ? 0.0 : resting_speed_);
    const bool bounces = approach > least && !pair.settled && !is_bedded(pair);
    const bool again = pair.settled;
    pair.settled = again || !bounces;
    Vec2 along = normal;
    Exchange done{0.0, approach};
    if (approach > 0.0) {
        const double restitution = bounces ? restitution_of(world, pair, approach) : 0.0;
        if (bounces && world.model.scatter)
            along = scattered_normal(world, world.balls.id[ball_[a]],
                                     world.balls.edge_contacts[ball_[a]]++, normal, velocity,
                                     restitution);
        done = bounce_off(velocity, mover_[a].inverse_mass, along, dot(surface, along), restitution,
                          is_driven);
        if (bounces && world.model.kicks)
            velocity += along * kick_at(world.materials[world.capsules.material[pair.edge]], shape,
                                        position, approach);
        if (world.model.spin)
            rub_on(velocity, {rim, 1.0}, mover_[a].inverse_mass, along, surface, done.impulse,
                   {pair.friction, *world.model.spin});
    }
    take_path(world, a, now, velocity, rim);
    if (along_normal > 0.0 && !is_driven) count_push(a, now);
    if (!(approach > rounding)) {
        if (again && !hand) wait_at(a, normal, now);
        return std::nullopt;
    }
    return Contact{.time = now,
                   .kind = ContactKind::ball_edge,
                   .a = ball_[a],
                   .b = pair.edge,
                   .point = position - normal * radius_[a],
                   .normal = along,
                   .approach = done.approach,
                   .impulse = done.impulse};
}

}  // namespace carom
