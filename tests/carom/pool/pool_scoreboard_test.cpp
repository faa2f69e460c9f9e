#include "carom/pool/pool_scoreboard.h"

#include <doctest/doctest.h>

#include "game/support/shipped.h"
#include "game/support/shots_game.h"

using namespace carom;

TEST_CASE("at three-cushion the scoreboard has each player's cue ball, points and inning") {
    test::ShotsGame game(test::shipped_level("three-cushion"));
    const PlayerNames names{"Ann", "Bob"};
    PoolPanel panel = scoreboard_of(game.session, names);
    REQUIRE(panel.players);
    CHECK((*panel.players)[0].name == "Ann");
    CHECK((*panel.players)[0].group == "white, inning 1");
    CHECK((*panel.players)[0].is_turn);
    CHECK((*panel.players)[1].group == "yellow");
    for (int turn = 0; turn < 2; ++turn) {
        game.shoot_softly();
        game.session.step_forward();
    }
    panel = scoreboard_of(game.session, names);
    REQUIRE(panel.players);
    CHECK((*panel.players)[0].group == "white, inning 2");
    CHECK((*panel.players)[1].group == "yellow, inning 1");
    CHECK((*panel.players)[0].frames == 0);
    CHECK(!(*panel.players)[1].is_turn);
}
