#include <doctest/doctest.h>

#include <cmath>
#include <optional>

#include "carom/pool/mouse_stroke.h"
#include "carom/pool/stroke_meter.h"

using namespace carom;

namespace {

/// Pulls back by `pull` and pushes through at `speed` and so many degrees off the line, reported 60
/// times a second.
std::optional<Stroke> push(double pull, double speed, double degrees, double grain = 0.0) {
    const Vec2 start{1.0, 0.5};
    MouseStroke hand(start, {1.0, 0.0}, 0.08, grain, 10.0);
    double time = 10.0;
    for (int i = 1; i <= 10; ++i)
        CHECK_FALSE(hand.move(start - Vec2{pull * i / 10.0, 0.0}, time += 1.0 / 60.0));
    CHECK(hand.pull() == doctest::Approx(pull));
    const double slope = std::tan(degrees * 3.14159265358979 / 180.0);
    for (double along = 0.0; along < pull + 0.5; along += speed / 60.0) {
        time += 1.0 / 60.0;
        if (const auto stroke = hand.move(start + Vec2{along - pull, along * slope}, time))
            return stroke;
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("the ball gets the speed of the mouse, and a crooked push misses") {
    for (const double speed : {0.5, 2.0, 8.0}) {
        CAPTURE(speed);
        const auto stroke = push(0.4, speed, 0.0);
        REQUIRE(stroke.has_value());
        CHECK(stroke->speed == doctest::Approx(speed).epsilon(0.01));
        CHECK(stroke->miss == 0.0);
    }
    const auto left = push(0.4, 2.0, 5.0);
    REQUIRE(left.has_value());
    CHECK(left->miss == doctest::Approx(0.25).epsilon(0.02));
    CHECK(push(0.4, 2.0, -10.0)->miss == doctest::Approx(-0.5).epsilon(0.02));
    CHECK(push(0.4, 2.0, 60.0)->miss == 1.0);
    // What the cells of the terminal cannot tell is no miss.
    CHECK(push(0.4, 2.0, 4.0, 0.03)->miss == 0.0);
}

TEST_CASE("a short pull does not strike, and neither does a hand that stays back") {
    CHECK_FALSE(push(0.05, 2.0, 0.0));
    MouseStroke hand({0.0, 0.0}, {0.0, 1.0}, 0.1, 0.0, 0.0);
    CHECK_FALSE(hand.move({0.0, -0.5}, 0.1));
    CHECK_FALSE(hand.move({0.0, -0.2}, 0.2));
    CHECK_FALSE(hand.move({0.0, -0.6}, 0.3));
    CHECK(hand.pull() == 0.6);
    // From the last turn it counts.
    const auto stroke = hand.move({0.0, 0.1}, 0.4);
    REQUIRE(stroke.has_value());
    CHECK(stroke->speed == doctest::Approx(7.0));
}

TEST_CASE("the mark of the meter swings, faster for harder shots, and the middle is straight") {
    StrokeMeter soft(1.0, 10.0);
    StrokeMeter hard(10.0, 10.0);
    CHECK(soft.mark() == 1.0);
    CHECK(hard.mark(0.25) == doctest::Approx(0.0));
    CHECK(soft.mark(0.25) > 0.4);
    hard.pass(0.5);
    CHECK(hard.mark() == doctest::Approx(-1.0));
    CHECK(hard.strike(0.5).miss == doctest::Approx(1.0));
    CHECK(hard.strike(0.5).speed == 10.0);
    CHECK_FALSE(hard.is_over());
    hard.pass(4.0);
    CHECK(hard.is_over());
    Look ascii;
    ascii.utf8 = false;
    CHECK(soft.text("enter", ascii) ==
          "stroke [O-----------|------------] press enter in the middle");
}
