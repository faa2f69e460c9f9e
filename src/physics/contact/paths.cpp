#include <algorithm>
#include <cmath>

#include "physics/contact/path.h"
#include "physics/contact/solver.h"

// The paths of the balls in a substep of the solver `contact` that has impacts: how they begin,
// what an impact makes of them, where they end, and what the balls have of them afterwards.
namespace carom {

void ContactSolver::begin_paths() {
    if (!has_pairs_of_bodies_) list_pairs_of_bodies();
    paths_.clear();
    place_of_path_.resize(still_, none);
    for (const Hand& hand : hands_)
        if (hand.is_ball) begin_path(hand.index);
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
    for (Press& press : presses_) {
        const Share a = given(press.a);
        const Share b = given(press.b);
        const double impulse = std::min(a.impulse, b.impulse);
        if (impulse < 1.0 && dot(velocity_then(press.a) - velocity_then(press.b), press.normal) >
                                 most_throw * resting_speed_)
            press.impulse *= impulse;
        press.rub *= std::min(a.rub, b.rub);
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

}  // namespace carom
