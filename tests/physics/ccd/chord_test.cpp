#include "physics/ccd/chord.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("chord: a point moves uniformly from where it was at its time") {
    const Chord chord{.position = {1.0, 2.0}, .velocity = {3.0, -1.0}, .time = 0.5};
    CHECK(chord.position_at(0.5) == Vec2{1.0, 2.0});
    CHECK(chord.position_at(2.5) == Vec2{7.0, 0.0});
}

TEST_CASE("chord: it ends where free flight does, with gravity and drag") {
    const Vec2 velocity{3.0, 4.0};
    const Vec2 gravity{0.0, -10.0};
    CHECK(chord_velocity(std::nullopt, velocity, gravity, 0.5) == Vec2{3.0, 1.5});
    const Vec2 end = chord_velocity(2.0, velocity, gravity, 0.5) * 0.5;
    const Vec2 flown = travel(flight_over(2.0, 0.5), velocity, gravity);
    CHECK(end.x == doctest::Approx(flown.x).epsilon(1e-15));
    CHECK(end.y == doctest::Approx(flown.y).epsilon(1e-15));
}

TEST_CASE("chord: where no time is left, it has the velocity itself") {
    CHECK(chord_velocity(2.0, {3.0, 4.0}, {0.0, -10.0}, 0.0) == Vec2{3.0, 4.0});
}
