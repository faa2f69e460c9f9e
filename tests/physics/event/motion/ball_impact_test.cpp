#include "physics/event/motion/ball_impact.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace carom;

namespace {

Trajectory<double> flight(double time, Vec2 position, Vec2 velocity, Vec2 acceleration = {}) {
    Trajectory<double> trajectory;
    trajectory.time = time;
    trajectory.position = Vector<double>(position);
    trajectory.velocity = Vector<double>(velocity);
    trajectory.acceleration = Vector<double>(acceleration);
    return trajectory;
}

std::optional<double> impact_of(const Trajectory<double>& a, const Trajectory<double>& b,
                                double end = 100.0) {
    ToiSearch<double> search;
    return ball_time_of_impact<double>(a, b, {}, 1.0, 0.5, Field<double>{}, end, search);
}

}  // namespace

TEST_CASE("ball impact: two in uniform motion meet where their distance is the sum of radii") {
    const auto resting = flight(0.0, {5.0, 0.0}, {});
    const auto head_on = flight(0.0, {0.0, 0.0}, {2.0, 0.0});
    CHECK(impact_of(head_on, resting) == 2.0);
    CHECK(impact_of(head_on, resting, 1.9) == std::nullopt);
    CHECK(impact_of(flight(0.0, {0.0, 0.6}, {2.0, 0.0}), resting) == doctest::Approx(2.1));
    CHECK(impact_of(flight(0.0, {0.0, 1.1}, {2.0, 0.0}), resting) == std::nullopt);
    CHECK(impact_of(flight(0.0, {0.0, 0.0}, {-2.0, 0.0}), resting) == std::nullopt);
}

TEST_CASE("ball impact: it counts from the later of two trajectories, and by image") {
    const auto early = flight(0.0, {0.0, 0.0}, {1.0, 0.0});
    const auto late = flight(3.0, {7.0, 0.0}, {-1.0, 0.0});
    // At 3 s they are 4 apart, and close at 2 a second.
    CHECK(impact_of(early, late) == 4.5);
    ToiSearch<double> search;
    const Vector<double> image{2.0, 0.0};
    CHECK(ball_time_of_impact<double>(early, late, image, 1.0, 0.5, {}, 100.0, search) == 5.5);
}

TEST_CASE("ball impact: an acceleration that both share changes only how they started") {
    const Vec2 gravity{0.0, -10.0};
    const auto a = flight(0.0, {0.0, 0.0}, {2.0, 0.0}, gravity);
    const auto b = flight(0.0, {5.0, 0.0}, {0.0, 0.0}, gravity);
    CHECK(impact_of(a, b) == 2.0);
    // b starts to fall a second later: by then a is 5 below, with a speed of 10 down.
    CHECK(impact_of(a, flight(1.0, {5.0, -5.0}, {0.0, -10.0}, gravity)) == 2.0);
}

TEST_CASE("ball impact: balls with different accelerations are searched") {
    // The gap of 4 shrinks by 2 t^2.
    const auto falling = flight(0.0, {0.0, 5.0}, {}, {0.0, -4.0});
    const auto floating = flight(0.0, {0.0, 0.0}, {});
    ToiSearch<double> search;
    const auto time = ball_time_of_impact<double>(falling, floating, {}, 1.0, 0.5, {}, 9.0, search);
    REQUIRE(time);
    CHECK(*time == doctest::Approx(std::sqrt(2.0)).epsilon(1e-12));
    CHECK(search.iterations > 0);
}

TEST_CASE("ball impact: touching balls meet at once if they approach, else not at all") {
    const auto b = flight(0.0, {1.0, 0.0}, {});
    CHECK(impact_of(flight(0.0, {0.0, 0.0}, {1.0, 0.0}), b) == 0.0);
    CHECK(impact_of(flight(0.0, {0.0, 0.0}, {1e-14, 1e3}), flight(0.0, {1.0, 0.0}, {0.0, 1e3})) ==
          std::nullopt);  // no more than rounding
    CHECK(impact_of(flight(0.0, {0.0, 0.0}, {0.0, 1.0}), b) == std::nullopt);
    CHECK(impact_of(flight(0.0, {0.0, 0.0}, {-1.0, 0.0}), b) == std::nullopt);
}

TEST_CASE("ball impact: whether they meet has the same bits as seen from either ball") {
    const Vector<double> offset{0.3, 4.1};
    const Vector<double> velocity{0.07, -1.3};
    const StraightApproach<double> there(offset, velocity, 1.0);
    const StraightApproach<double> back(-offset, -velocity, 1.0);
    CHECK(there.approach == back.approach);
    CHECK(there.discriminant == back.discriminant);
    CHECK(there.is_impact());
}
