#include <doctest/doctest.h>

#include <algorithm>

#include "carom/pool/pool_aim.h"
#include "game/support/shipped.h"
#include "game/support/shots_game.h"

using namespace carom;
using carom::test::shipped_level;
using carom::test::ShotsGame;

TEST_CASE("balls that a drill sets up again keep their colours: the cue ball stays white") {
    ShotsGame game(shipped_level("drill-stop"));
    CHECK(returned_of(game.session).empty());
    const std::vector<BallId> before = game.session.world().balls().id;
    game.shoot_softly();
    const BallId cue = *cue_ball_of(game.session.scene(), game.state());
    CHECK(std::ranges::count(before, cue) == 0);
    const auto numbers = numbers_of(game.session);
    REQUIRE(numbers.size() == 1);
    CHECK(numbers.front().ball == cue);
    CHECK(numbers.front().number == 0);
    const auto returned = returned_of(game.session);
    REQUIRE(returned.size() == 2);
    for (const PoolAnnotations::Returned& ball : returned) {
        CHECK(index_of(game.session.world(), ball.ball));
        CHECK(std::ranges::count(before, ball.before) == 1);
    }
}
