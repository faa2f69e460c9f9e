#pragma once

#include <cstdint>
#include <vector>

#include <gmpxx.h>

#include "physics/world/world.h"

/// A slow reference for the solver `event` that shares no code with it: numbers of 60 digits and
/// more, every pair tested, no cells, no queue; impacts are found by bracketing the roots of
/// polynomials between the roots of their derivatives. It supports fixed balls and edges, gravity
/// and restitution; nothing rests, and no two impacts are simultaneous. Built if Debian's
/// libgmp-dev is installed.
namespace carom::oracle {

using Number = mpf_class;

/// The precision of numbers created from here on: 320 bits, 96 digits.
void use_many_digits();

struct Point {
    Number x;
    Number y;
};

struct Ball {
    Point position;
    Point velocity;
    Number radius;
    Number inverse_mass;
    Number restitution;
};

struct Impact {
    double time = 0.0;
    std::uint32_t a = 0;
    std::int64_t b = 0;  ///< ball; or -1 - capsule
};

class Oracle {
  public:
    /// Takes the balls and edges of `world`.
    explicit Oracle(const World& world);

    /// Displaces the start of ball `index` by `way` and changes its velocity by `push`. Pre:
    /// nothing has moved yet.
    void nudge(std::size_t index, const Point& way, const Point& push);

    /// Advances to `time`, s.
    void run_until(const Number& time);

    Point position(std::size_t index) const;
    const std::vector<Impact>& impacts() const { return impacts_; }

  private:
    struct Edge {
        Point start;
        Point end;
        Number radius;
        Number restitution;
    };
    struct Next {
        bool is_there = false;
        Number time;
        std::int64_t other = 0;
        Point normal;  ///< from the other body to the ball
    };

    Point place_at(std::size_t ball, const Number& time) const;
    void find_next(std::size_t ball, const Number& end);
    void look_at_ball(std::size_t ball, std::size_t other, Number& end);
    void look_at_edge(std::size_t ball, std::size_t edge, Number& end);
    void look_at_point(std::size_t ball, std::size_t edge, int part, const Point& point,
                       Number& end);
    void meet(std::size_t ball);
    void advance(std::size_t ball, const Number& time);

    Point gravity_;
    std::vector<Ball> balls_;
    std::vector<Number> since_;  ///< the time at which each ball was at its position in `balls_`
    std::vector<std::int64_t> last_;  ///< the body it just hit: ball, or -1 - 4 capsule - part
    std::vector<Next> next_;
    std::vector<Edge> edges_;
    std::vector<Impact> impacts_;
    Number now_;
};

}  // namespace carom::oracle
