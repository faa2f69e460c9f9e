#include "level/ir/ball_list.h"

#include <doctest/doctest.h>

#include "level/ir/level_ir.h"

using namespace carom;

namespace {

BallIr ball(double x, int line, int binding = 0) {
    static const SourceText source{};
    BallIr made;
    made.position = {x, -x};
    made.radius = 2.0;
    made.velocity = {3.0, 4.0};
    made.binding = binding;
    made.origin = Origin({&source, line, 7, 5}, 2);
    return made;
}

}  // namespace

TEST_CASE("balls that differ in place and origin alone share the rest, and come back whole") {
    BallList balls;
    CHECK(balls.empty());
    CHECK(balls.push_back(ball(1.0, 10)));
    CHECK_FALSE(balls.push_back(ball(2.0, 11)));
    CHECK(balls.push_back(ball(3.0, 12, 1)));
    CHECK_FALSE(balls.push_back(ball(4.0, 13)));  // as in a map of two letters
    BallIr other = ball(5.0, 14);
    other.spin = 1.0;
    CHECK(balls.push_back(other));
    REQUIRE(balls.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        const BallIr made = balls[i];
        CHECK(made.position.x == static_cast<double>(i + 1));
        CHECK(made.radius == 2.0);
        CHECK(made.velocity == Vec2{3.0, 4.0});
        CHECK(made.spin == (i == 4 ? 1.0 : 0.0));
        CHECK(made.binding == (i == 2 ? 1 : 0));
        CHECK(made.origin.image == 2);
        CHECK(made.origin.span().line == static_cast<int>(i + 10));
        CHECK(made.origin.span().column == 7);
        CHECK(made.origin.span().length == 5);
    }
    balls.remove({true, false, true, false, false});
    REQUIRE(balls.size() == 3);
    CHECK(balls[0].position.x == 2.0);
    CHECK(balls[2].spin == 1.0);
}

// Regression: a million edges, and an error in the last line, took more than 100 MB.
TEST_CASE("a million edges and their origins fit into 80 MB") {
    CHECK(sizeof(Origin) <= 24);
    CHECK(sizeof(CapsuleIr) <= 80);
}
