#include "physics/ccd/time_of_impact.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("time of impact of two balls: the sum of radii less the allowed overlap") {
    const auto none = [] { return 0.0; };
    const auto impact = impact_of_balls({10.0, 0.0}, {-2.0, 0.0}, 1.0, 2.0, 5.0, none);
    REQUIRE(impact);
    CHECK(impact->time == 3.5);
    CHECK(impact->normal == Vec2{1.0, 0.0});
    const auto later = impact_of_balls({10.0, 0.0}, {-2.0, 0.0}, 1.0, 2.0, 5.0, [] { return 0.5; });
    REQUIRE(later);
    CHECK(later->time == 3.75);
    CHECK(!impact_of_balls({10.0, 0.0}, {-2.0, 0.0}, 1.0, 2.0, 3.0, none));
}

TEST_CASE("time of impact of two balls: a pair that stays apart is not asked for its overlap") {
    int asked = 0;
    const auto overlap = [&] {
        ++asked;
        return 0.0;
    };
    CHECK(!impact_of_balls({10.0, 0.0}, {1.0, 0.0}, 1.0, 1.0, 5.0, overlap));
    CHECK(asked == 0);
    CHECK(impact_of_balls({10.0, 0.0}, {-4.0, 0.0}, 1.0, 1.0, 5.0, overlap));
    CHECK(asked == 1);
}

TEST_CASE("time of impact with a kinematic edge: moving, held back and stopped") {
    const Disc ball{{0.0, 5.0}, 1.0};
    const Vec2 velocity{0.0, -1.0};
    const Capsule shape{{-3.0, 0.0}, {3.0, 0.0}, 0.5};
    HeldEdge edge{.start_velocity = {0.0, 1.0}, .end_velocity = {0.0, 1.0}};
    const auto time = [&] {
        const auto impact = impact_with_moving_edge(ball, velocity, shape, edge, 10.0);
        REQUIRE(impact);
        return impact->time;
    };
    CHECK(time() == doctest::Approx(1.75).epsilon(1e-11));
    edge.share = 0.75;
    CHECK(time() == doctest::Approx(2.0).epsilon(1e-11));
    edge.stop(0.1);
    CHECK(edge.version == 1);
    CHECK(time() == doctest::Approx(3.5).epsilon(1e-11));
}
