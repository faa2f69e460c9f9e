#include "physics/support/oracle.h"

namespace carom::oracle {
namespace {

constexpr std::int64_t nothing = INT64_MIN;

Point operator+(const Point& a, const Point& b) {
    return {a.x + b.x, a.y + b.y};
}
Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
}
Point operator*(const Point& a, const Number& s) {
    return {a.x * s, a.y * s};
}
Number dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y;
}
Number length(const Point& a) {
    return sqrt(dot(a, a));
}

using Polynomial = std::vector<Number>;  // coefficients, the constant first

Number value(const Polynomial& p, const Number& t) {
    Number sum = 0;
    for (std::size_t i = p.size(); i-- > 0;)
        sum = sum * t + p[i];
    return sum;
}

Polynomial derivative(const Polynomial& p) {
    Polynomial result;
    for (std::size_t i = 1; i < p.size(); ++i)
        result.push_back(p[i] * static_cast<double>(i));
    return result;
}

// The root between two points of opposite sign: bisection, then Newton's method.
Number root_between(const Polynomial& p, Number low, Number high) {
    const int sign = sgn(value(p, low));
    Number middle;
    for (int i = 0; i < 70; ++i) {
        middle = (low + high) / 2;
        if (sgn(value(p, middle)) == sign)
            low = middle;
        else
            high = middle;
    }
    const Polynomial slope = derivative(p);
    Number root = (low + high) / 2;
    for (int i = 0; i < 4; ++i) {
        const Number steep = value(slope, root);
        if (steep == 0) break;
        const Number next = root - value(p, root) / steep;
        if (next < low || next > high) break;
        root = next;
    }
    if (sgn(value(slope, root)) != 0) return root;
    for (int i = 0; i < 260; ++i) {
        middle = (low + high) / 2;
        (sgn(value(p, middle)) == sign ? low : high) = middle;
    }
    return low;
}

// All sign changes in 0..end, ascending.
std::vector<Number> roots(const Polynomial& p, const Number& end) {
    std::vector<Number> result;
    if (p.size() < 2) return result;
    std::vector<Number> places = roots(derivative(p), end);
    places.insert(places.begin(), Number(0));
    places.push_back(end);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const int before = sgn(value(p, places[i]));
        const int after = sgn(value(p, places[i + 1]));
        if (before != 0 && after != 0 && before != after)
            result.push_back(root_between(p, places[i], places[i + 1]));
    }
    return result;
}

// The first time after 0, up to `end`, at which p changes from positive to negative. A contact has
// p = 0 at 0, and that root does not count.
bool first_fall(Polynomial p, bool is_touching, const Number& end, Number& time) {
    if (is_touching) p.erase(p.begin());
    while (!p.empty() && p.back() == 0)
        p.pop_back();
    if (p.empty() || !(end > 0)) return false;
    int sign = sgn(p[0]);
    for (const Number& root : roots(p, end)) {
        if (sign > 0) {
            time = root;
            return true;
        }
        sign = -sign;
    }
    return false;
}

}  // namespace

void use_many_digits() {
    mpf_set_default_prec(320);
}

Oracle::Oracle(const World& world) : now_(0) {
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    gravity_ = {gravity.x, gravity.y};
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 p = world.balls().position[i];
        const Vec2 v = world.balls().velocity[i];
        const double e = world.model().lossy ? world.balls().restitution[i] : 1.0;
        balls_.push_back(
            {{p.x, p.y}, {v.x, v.y}, world.balls().radius[i], world.balls().inverse_mass[i], e});
    }
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        const Capsule& c = world.capsules().shape[i];
        edges_.push_back({{c.start.x, c.start.y},
                          {c.end.x, c.end.y},
                          c.radius,
                          world.materials()[world.capsules().material[i]].restitution});
    }
    since_.assign(balls_.size(), Number(0));
    last_.assign(balls_.size(), nothing);
    next_.resize(balls_.size());
}

void Oracle::nudge(std::size_t index, const Point& way, const Point& push) {
    balls_[index].position = balls_[index].position + way;
    balls_[index].velocity = balls_[index].velocity + push;
}

Point Oracle::place_at(std::size_t ball, const Number& time) const {
    const Number since = time - since_[ball];
    return balls_[ball].position + balls_[ball].velocity * since +
           gravity_ * Number(since * since / 2);
}

Point Oracle::position(std::size_t index) const {
    return place_at(index, now_);
}

void Oracle::advance(std::size_t ball, const Number& time) {
    const Number since = time - since_[ball];
    balls_[ball].position = place_at(ball, time);
    balls_[ball].velocity = balls_[ball].velocity + gravity_ * since;
    since_[ball] = time;
}

// Their relative motion is linear. `end` is the earliest impact found so far, and decreases.
void Oracle::look_at_ball(std::size_t ball, std::size_t other, Number& end) {
    const Point offset = place_at(ball, now_) - place_at(other, now_);
    const Point velocity = balls_[ball].velocity + gravity_ * Number(now_ - since_[ball]) -
                           balls_[other].velocity - gravity_ * Number(now_ - since_[other]);
    const Number reach = balls_[ball].radius + balls_[other].radius;
    const Polynomial gap{dot(offset, offset) - reach * reach, 2 * dot(offset, velocity),
                         dot(velocity, velocity)};
    const bool is_touching = last_[ball] == static_cast<std::int64_t>(other) &&
                             last_[other] == static_cast<std::int64_t>(ball);
    Number since;
    if (!first_fall(gap, is_touching, end - now_, since)) return;
    end = now_ + since;
    const Point there = offset + velocity * since;
    const Number size = length(there);
    next_[ball] = {true, end, static_cast<std::int64_t>(other), there * Number(1 / size)};
}

void Oracle::look_at_point(std::size_t ball, std::size_t edge, int part, const Point& point,
                           Number& end) {
    const std::int64_t name = -1 - 4 * static_cast<std::int64_t>(edge) - part;
    const Point offset = balls_[ball].position - point;
    const Point& velocity = balls_[ball].velocity;
    const Number reach = balls_[ball].radius + edges_[edge].radius;
    const Number most = end - now_;
    // Too far away to arrive in time.
    const Number range = length(velocity) * most + length(gravity_) * most * most / 2 + reach;
    const Number far = dot(offset, offset);
    if (far > range * range) return;
    const Polynomial gap{far - reach * reach, 2 * dot(offset, velocity),
                         dot(velocity, velocity) + dot(offset, gravity_), dot(velocity, gravity_),
                         dot(gravity_, gravity_) / 4};
    Number since;
    if (!first_fall(gap, last_[ball] == name, most, since)) return;
    end = now_ + since;
    const Point there = place_at(ball, end) - point;
    const Number size = length(there);
    next_[ball] = {true, end, name, there * Number(1 / size)};
}

void Oracle::look_at_edge(std::size_t ball, std::size_t index, Number& end) {
    const Edge& edge = edges_[index];
    const Point span = edge.end - edge.start;
    const Number whole = length(span);
    if (whole > 0) {
        const Point along = span * Number(1 / whole);
        const Point offset = balls_[ball].position - edge.start;
        for (const int side : {1, -1}) {
            const std::int64_t name =
                -1 - 4 * static_cast<std::int64_t>(index) - (side > 0 ? 0 : 1);
            const Point normal{-along.y * side, along.x * side};
            const Polynomial gap{dot(normal, offset) - balls_[ball].radius - edge.radius,
                                 dot(normal, balls_[ball].velocity), dot(normal, gravity_) / 2};
            Number since;
            if (!first_fall(gap, last_[ball] == name, end - now_, since)) continue;
            const Number time = now_ + since;
            const Number foot = dot(along, place_at(ball, time) - edge.start);
            if (foot < 0 || foot > whole) continue;
            end = time;
            next_[ball] = {true, end, name, normal};
        }
        look_at_point(ball, index, 3, edge.end, end);
    }
    look_at_point(ball, index, 2, edge.start, end);
}

void Oracle::find_next(std::size_t ball, const Number& horizon) {
    next_[ball] = {};
    Number end = horizon;
    for (std::size_t other = 0; other < balls_.size(); ++other)
        if (other != ball) look_at_ball(ball, other, end);
    for (std::size_t edge = 0; edge < edges_.size(); ++edge)
        look_at_edge(ball, edge, end);
}

void Oracle::meet(std::size_t ball) {
    const Next next = next_[ball];
    Ball& ours = balls_[ball];
    if (next.other >= 0) {
        const auto other = static_cast<std::size_t>(next.other);
        Ball& theirs = balls_[other];
        const Number e =
            ours.restitution < theirs.restitution ? ours.restitution : theirs.restitution;
        const Number closing = -dot(next.normal, ours.velocity - theirs.velocity);
        const Number impulse = (1 + e) * closing / (ours.inverse_mass + theirs.inverse_mass);
        ours.velocity = ours.velocity + next.normal * Number(impulse * ours.inverse_mass);
        theirs.velocity = theirs.velocity - next.normal * Number(impulse * theirs.inverse_mass);
        last_[ball] = next.other;
        last_[other] = static_cast<std::int64_t>(ball);
        impacts_.push_back({next.time.get_d(), static_cast<std::uint32_t>(ball), next.other});
        return;
    }
    const std::int64_t edge = (-1 - next.other) / 4;
    const Number e = edges_[static_cast<std::size_t>(edge)].restitution;
    const Number closing = -dot(next.normal, ours.velocity);
    ours.velocity = ours.velocity + next.normal * Number((1 + e) * closing);
    last_[ball] = next.other;
    impacts_.push_back({next.time.get_d(), static_cast<std::uint32_t>(ball), -1 - edge});
}

void Oracle::run_until(const Number& time) {
    for (;;) {
        // Recomputes everything at every impact.
        std::size_t first = balls_.size();
        Number end = time;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            find_next(i, end);
            if (!next_[i].is_there) continue;
            first = i;
            end = next_[i].time;
        }
        if (now_ < end) last_.assign(balls_.size(), nothing);
        now_ = end;
        for (std::size_t i = 0; i < balls_.size(); ++i)
            advance(i, now_);
        if (first == balls_.size()) return;
        meet(first);
    }
}

}  // namespace carom::oracle
