#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lab/measure/oracle_roots.h"
#include "physics/world/world.h"

/// A slow reference for the solver `event` that shares no code with it, and takes nothing but
/// positions, velocities and shapes: every pair is tested, without cells or a queue, and impacts
/// are found by bracketing the roots of polynomials between the roots of their derivatives. It
/// supports fixed balls and edges, gravity and restitution; nothing rests, and no two impacts are
/// simultaneous.
///
/// `Number` has + - * /, comparisons, conversion from double, and by argument-dependent look-up
/// sqrt_of, sign_of and double_of: DoubleDouble for `carom measure` (independent.cpp), 96 digits
/// for tests.
///
/// The file is long since it is one class template, which tests instantiate with a Number of their
/// own.
namespace carom::oracle {

struct OracleImpact {
    double time = 0.0;
    std::uint32_t a = 0;
    std::int64_t b = 0;  ///< ball; or -1 - capsule
};

/// Why an oracle went no further.
enum class Stop : std::uint8_t {
    none,
    work,          ///< it would have had to test more pairs than allowed
    simultaneous,  ///< bodies that touch: impacts at one instant, rest, or overlap
};

template <typename Number>
class Oracle {
  public:
    using Place = Point<Number>;

    /// Takes the balls and edges of `world`. `most_tests`: of pairs, before it stops.
    explicit Oracle(const World& world, std::uint64_t most_tests = UINT64_MAX);

    /// Displaces the start of ball `index` by `way` and changes its velocity by `push`. Pre:
    /// nothing has moved yet.
    void nudge(std::size_t index, const Place& way, const Place& push);

    /// Advances to `time`, s, or as far as it gets. `horizon`: as far ahead as impacts are
    /// predicted at once; set it to the last time if there are several.
    Stop run_until(const Number& time, const Number& horizon);
    Stop run_until(const Number& time) { return run_until(time, time); }

    Place position(std::size_t index) const { return place_at(index, now_); }
    const std::vector<OracleImpact>& impacts() const { return impacts_; }

  private:
    struct Ball {
        Place position;
        Place velocity;
        Number radius;
        Number inverse_mass;
        Number restitution;
        Number since;           ///< when it was there
        std::int64_t last = 0;  ///< the body it hit then: ball, or -1 - 4 capsule - part
        bool has_hit = false;   ///< then, and not before or after
    };
    struct Edge {
        Place start;
        Place end;
        Number radius;
        Number restitution;
    };
    struct Next {
        bool is_there = false;
        Number time;
        std::int64_t other = 0;
        Place normal;  ///< from the other body to the ball
    };

    Place place_at(std::size_t ball, const Number& time) const;
    Place velocity_at(std::size_t ball, const Number& time) const;
    bool note_touch(const std::vector<Number>& gap);
    bool hit_now(std::size_t ball, std::int64_t what) const;
    bool can_reach(const Place& offset, const Place& velocity, const Place& pull,
                   const Number& reach, const Number& most) const;
    void find_next(std::size_t ball, const Number& horizon);
    void look_at_ball(std::size_t ball, std::size_t other, Number& end);
    void look_at_edge(std::size_t ball, std::size_t edge, Number& end);
    void look_at_point(std::size_t ball, std::size_t edge, int part, const Place& point,
                       Number& end);
    void meet(std::size_t ball);
    void advance(std::size_t ball, const Number& time);
    bool is_too_soon(std::size_t ball) const;

    Place gravity_;
    std::vector<Ball> balls_;
    std::vector<Next> next_;
    std::vector<Edge> edges_;
    std::vector<OracleImpact> impacts_;
    Number now_;
    Number predicted_;  ///< impacts are known up to then
    std::uint64_t tests_left_ = 0;
    bool has_touch_ = false;
};

template <typename Number>
Oracle<Number>::Oracle(const World& world, std::uint64_t most_tests)
    : now_(0.0), predicted_(-1.0), tests_left_(most_tests) {
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    gravity_ = {Number(gravity.x), Number(gravity.y)};
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 p = world.balls().position[i];
        const Vec2 v = world.balls().velocity[i];
        const double e = world.model().inelastic ? world.balls().restitution[i] : 1.0;
        balls_.push_back({.position = {Number(p.x), Number(p.y)},
                          .velocity = {Number(v.x), Number(v.y)},
                          .radius = Number(world.balls().radius[i]),
                          .inverse_mass = Number(world.balls().inverse_mass[i]),
                          .restitution = Number(e),
                          .since = Number(0.0)});
    }
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        const Capsule& c = world.capsules().shape[i];
        edges_.push_back({{Number(c.start.x), Number(c.start.y)},
                          {Number(c.end.x), Number(c.end.y)},
                          Number(c.radius),
                          Number(world.materials()[world.capsules().material[i]].restitution)});
    }
    next_.resize(balls_.size());
}

template <typename Number>
void Oracle<Number>::nudge(std::size_t index, const Place& way, const Place& push) {
    using namespace detail;
    balls_[index].position = balls_[index].position + way;
    balls_[index].velocity = balls_[index].velocity + push;
}

template <typename Number>
auto Oracle<Number>::place_at(std::size_t ball, const Number& time) const -> Place {
    using namespace detail;
    const Number since(time - balls_[ball].since);
    return balls_[ball].position + balls_[ball].velocity * since +
           gravity_ * Number(since * since * Number(0.5));
}

template <typename Number>
auto Oracle<Number>::velocity_at(std::size_t ball, const Number& time) const -> Place {
    using namespace detail;
    return balls_[ball].velocity + gravity_ * Number(time - balls_[ball].since);
}

// Whether its impact with that body is at this very instant, so that they touch.
template <typename Number>
bool Oracle<Number>::hit_now(std::size_t ball, std::int64_t what) const {
    const Ball& one = balls_[ball];
    return one.has_hit && one.last == what && !(one.since < now_);
}

// Two bodies that touch or overlap, approach, and have not just met, need more than a pairwise
// impact. `gap`: their distance or its square as a polynomial in time.
template <typename Number>
bool Oracle<Number>::note_touch(const std::vector<Number>& gap) {
    if (sign_of(gap[0]) > 0 || sign_of(gap[1]) > 0) return false;
    if (sign_of(gap[1]) == 0 && sign_of(gap[2]) >= 0) return false;
    has_touch_ = true;
    return true;
}

template <typename Number>
void Oracle<Number>::advance(std::size_t ball, const Number& time) {
    const Place place = place_at(ball, time);
    const Place velocity = velocity_at(ball, time);
    Ball& one = balls_[ball];
    one.has_hit = one.has_hit && !(one.since < time);
    one.position = place;
    one.velocity = velocity;
    one.since = time;
}

// False: they are too far apart to meet within `most`, judged generously.
template <typename Number>
bool Oracle<Number>::can_reach(const Place& offset, const Place& velocity, const Place& pull,
                               const Number& reach, const Number& most) const {
    const auto size = [](const Place& p) {
        const double x = double_of(p.x);
        const double y = double_of(p.y);
        return std::sqrt(x * x + y * y);
    };
    const double time = double_of(most);
    const double way = time * (size(velocity) + 0.5 * time * size(pull));
    return size(offset) <= (double_of(reach) + way) * (1.0 + 1e-9);
}

// Their relative motion is linear. `end` is the earliest impact found so far, and decreases.
template <typename Number>
void Oracle<Number>::look_at_ball(std::size_t ball, std::size_t other, Number& end) {
    using namespace detail;
    const Place offset = place_at(ball, now_) - place_at(other, now_);
    const Place velocity = velocity_at(ball, now_) - velocity_at(other, now_);
    const Number reach(balls_[ball].radius + balls_[other].radius);
    const Number most(end - now_);
    if (!can_reach(offset, velocity, {Number(0.0), Number(0.0)}, reach, most)) return;
    const Polynomial<Number> gap{Number(dot(offset, offset) - reach * reach),
                                 Number(Number(2.0) * dot(offset, velocity)),
                                 dot(velocity, velocity)};
    if (passes_by(double_of(gap[0]), double_of(gap[1]), double_of(gap[2]))) return;
    const bool is_touching = hit_now(ball, static_cast<std::int64_t>(other)) &&
                             hit_now(other, static_cast<std::int64_t>(ball));
    if (!is_touching && note_touch(gap)) return;
    Number since(0.0);
    if (!first_fall(gap, is_touching, most, since)) return;
    end = Number(now_ + since);
    const Place there = offset + velocity * since;
    next_[ball] = {true, end, static_cast<std::int64_t>(other),
                   there * Number(Number(1.0) / sqrt_of(dot(there, there)))};
}

template <typename Number>
void Oracle<Number>::look_at_point(std::size_t ball, std::size_t edge, int part, const Place& point,
                                   Number& end) {
    using namespace detail;
    const std::int64_t name = -1 - 4 * static_cast<std::int64_t>(edge) - part;
    const Place offset = place_at(ball, now_) - point;
    const Place velocity = velocity_at(ball, now_);
    const Number reach(balls_[ball].radius + edges_[edge].radius);
    const Number most(end - now_);
    if (!can_reach(offset, velocity, gravity_, reach, most)) return;
    const Polynomial<Number> gap{
        Number(dot(offset, offset) - reach * reach), Number(Number(2.0) * dot(offset, velocity)),
        Number(dot(velocity, velocity) + dot(offset, gravity_)), dot(velocity, gravity_),
        Number(dot(gravity_, gravity_) * Number(0.25))};
    if (!hit_now(ball, name) && note_touch(gap)) return;
    Number since(0.0);
    if (!first_fall(gap, hit_now(ball, name), most, since)) return;
    end = Number(now_ + since);
    const Place there = place_at(ball, end) - point;
    next_[ball] = {true, end, name, there * Number(Number(1.0) / sqrt_of(dot(there, there)))};
}

template <typename Number>
void Oracle<Number>::look_at_edge(std::size_t ball, std::size_t index, Number& end) {
    using namespace detail;
    const Edge& edge = edges_[index];
    const Place span = edge.end - edge.start;
    const Number whole = sqrt_of(dot(span, span));
    if (sign_of(whole) > 0) {
        const Place along = span * Number(Number(1.0) / whole);
        const Place offset = place_at(ball, now_) - edge.start;
        const Place velocity = velocity_at(ball, now_);
        for (const int side : {1, -1}) {
            const std::int64_t name =
                -1 - 4 * static_cast<std::int64_t>(index) - (side > 0 ? 0 : 1);
            const Number turn(static_cast<double>(side));
            const Place normal{Number(Number(0.0) - along.y * turn), Number(along.x * turn)};
            const Polynomial<Number> gap{
                Number(dot(normal, offset) - balls_[ball].radius - edge.radius),
                dot(normal, velocity), Number(dot(normal, gravity_) * Number(0.5))};
            // The other side of the line is no contact, but a hair beyond it is one.
            const Number now_foot = dot(along, offset);
            if (double_of(gap[0]) > -1e-6 * double_of(balls_[ball].radius) &&
                sign_of(now_foot) >= 0 && !(now_foot > whole) && !hit_now(ball, name) &&
                note_touch(gap))
                return;
            Number since(0.0);
            if (!first_fall(gap, hit_now(ball, name), Number(end - now_), since)) continue;
            const Number time(now_ + since);
            const Number foot = dot(along, place_at(ball, time) - edge.start);
            if (sign_of(foot) < 0 || foot > whole) continue;
            end = time;
            next_[ball] = {true, end, name, normal};
        }
        look_at_point(ball, index, 3, edge.end, end);
    }
    look_at_point(ball, index, 2, edge.start, end);
}

template <typename Number>
void Oracle<Number>::find_next(std::size_t ball, const Number& horizon) {
    next_[ball] = {};
    Number end = horizon;
    for (std::size_t other = 0; other < balls_.size(); ++other)
        if (other != ball) look_at_ball(ball, other, end);
    for (std::size_t edge = 0; edge < edges_.size(); ++edge)
        look_at_edge(ball, edge, end);
    const std::uint64_t tests = balls_.size() + 4 * edges_.size();
    tests_left_ -= std::min(tests, tests_left_);
}

// Whether the ball has just hit something else: pairwise impacts would then depend on their order.
template <typename Number>
bool Oracle<Number>::is_too_soon(std::size_t ball) const {
    const Ball& one = balls_[ball];
    if (!one.has_hit) return false;
    return double_of(now_) - double_of(one.since) <= 1e-12 * (1.0 + double_of(now_));
}

template <typename Number>
void Oracle<Number>::meet(std::size_t ball) {
    using namespace detail;
    const Next next = next_[ball];
    Ball& ours = balls_[ball];
    advance(ball, now_);
    if (next.other >= 0) {
        const auto other = static_cast<std::size_t>(next.other);
        advance(other, now_);
        Ball& theirs = balls_[other];
        const Number e =
            ours.restitution < theirs.restitution ? ours.restitution : theirs.restitution;
        const Number closing(Number(0.0) - dot(next.normal, ours.velocity - theirs.velocity));
        const Number impulse((Number(1.0) + e) * closing /
                             (ours.inverse_mass + theirs.inverse_mass));
        ours.velocity = ours.velocity + next.normal * Number(impulse * ours.inverse_mass);
        theirs.velocity = theirs.velocity - next.normal * Number(impulse * theirs.inverse_mass);
        theirs.last = static_cast<std::int64_t>(ball);
        theirs.has_hit = true;
        impacts_.push_back({double_of(next.time), static_cast<std::uint32_t>(ball), next.other});
    } else {
        const std::int64_t edge = (-1 - next.other) / 4;
        const Number e = edges_[static_cast<std::size_t>(edge)].restitution;
        const Number closing(Number(0.0) - dot(next.normal, ours.velocity));
        ours.velocity = ours.velocity + next.normal * Number((Number(1.0) + e) * closing);
        impacts_.push_back({double_of(next.time), static_cast<std::uint32_t>(ball), -1 - edge});
    }
    ours.last = next.other;
    ours.has_hit = true;
}

template <typename Number>
Stop Oracle<Number>::run_until(const Number& time, const Number& horizon) {
    if (predicted_ < horizon) {
        predicted_ = horizon;
        for (std::size_t i = 0; i < balls_.size(); ++i)
            find_next(i, predicted_);
    }
    for (;;) {
        if (tests_left_ == 0) return Stop::work;
        if (has_touch_) return Stop::simultaneous;
        std::size_t first = balls_.size();
        for (std::size_t i = 0; i < balls_.size(); ++i)
            if (next_[i].is_there && !(time < next_[i].time) &&
                (first == balls_.size() || next_[i].time < next_[first].time))
                first = i;
        if (first == balls_.size()) break;
        now_ = next_[first].time;
        const auto one = static_cast<std::int64_t>(first);
        const std::int64_t other = next_[first].other;
        if (is_too_soon(first) || (other >= 0 && is_too_soon(static_cast<std::size_t>(other))))
            return Stop::simultaneous;
        meet(first);
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const auto self = static_cast<std::int64_t>(i);
            const bool met = self == one || self == other;
            const bool would_meet = next_[i].is_there && next_[i].other >= 0 &&
                                    (next_[i].other == one || next_[i].other == other);
            if (met || would_meet) find_next(i, predicted_);
        }
    }
    now_ = time;
    return Stop::none;
}

}  // namespace carom::oracle
