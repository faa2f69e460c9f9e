#include "carom/pool/pool_scoreboard.h"

#include <doctest/doctest.h>

#include "carom/play/player.h"
#include "game/support/shipped.h"
#include "game/support/shots_game.h"
#include "physics/world/fingerprint.h"

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

TEST_CASE("a recording of pool is watched with numbered balls and the score, as it was played") {
    Scene scene = test::shipped_level("eight-ball");
    const SolverSettings solver = pick_solver(scene.world).settings;
    Session session(std::move(scene), solver);
    session.follow({}, 600, fingerprint_version);
    ViewOptions view;
    view.renderer = &half_block_renderer();
    view.look = {256, true, false};
    Player player(std::move(session), view, KeyMap());
    REQUIRE(player.is_watching());
    Canvas window(200, 60);
    player.draw(window, 2.0);
    const std::string text = window.text();
    CHECK(text.find("0 : 0") != std::string::npos);
    for (const char* const number : {"15", "11", "4", "9"})
        CHECK(text.find(number) != std::string::npos);
}
