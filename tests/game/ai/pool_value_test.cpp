#include "game/ai/pool_value.h"

#include <doctest/doctest.h>

#include <optional>

#include "game/referees/referee.h"
#include "game/support/shipped.h"

using namespace carom;

namespace {

// The value to the breaker, with the cue ball in hand, of a rack whose ball 1 lies at this place.
double value_with_ball_at(const char* level, Vec2 place) {
    const Scene scene = test::shipped_level(level);
    PoolPlay play = *begin_pool(scene, 0);
    play.rules.phase = PoolPhase::playing;
    World world = scene.world;
    world.edit_balls().position[*index_of(world, *play.balls[1])] = place;
    const auto cloth = cloth_box(scene);
    REQUIRE(cloth);
    const double value = value_to(0, scene, world, play, *cloth, 1.0);
    CHECK(value_to(1, scene, world, play, *cloth, 1.0) == -value);
    return value;
}

}  // namespace

TEST_CASE("one-pocket: balls near the own pocket are worth more than those near the opponent's") {
    // The breaker's pocket is the right one at the far end, seen from the head of the table.
    const double own = value_with_ball_at("one-pocket", {1.1, -0.5});
    const double middle = value_with_ball_at("one-pocket", {1.1, 0.0});
    const double other = value_with_ball_at("one-pocket", {1.1, 0.5});
    CHECK(own > middle);
    CHECK(middle > other);
    CHECK(own - middle == doctest::Approx(middle - other));
    CHECK(own - other < 0.12);  // less than two balls
}

TEST_CASE("where all pockets serve both players, no ball is nearer to one of them") {
    CHECK(value_with_ball_at("eight-ball", {1.1, -0.5}) ==
          value_with_ball_at("eight-ball", {1.1, 0.5}));
}
