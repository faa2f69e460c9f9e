#include <doctest/doctest.h>

#include <algorithm>

#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_status.h"
#include "game/pool/table_places.h"
#include "game/referees/snooker.h"
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

TEST_CASE("a colour of snooker keeps its colour when it returns to its spot") {
    Scene scene = shipped_level("snooker");
    const BallId black = test::named(scene, "black");
    const BallId cue = scene.pool.cue->ball;
    scene.world.edit_balls().position[*index_of(scene.world, black)] = {1.75, 0.855};
    scene.world.edit_balls().position[*index_of(scene.world, cue)] = {1.5, 0.605};
    const SolverSettings solver = pick_solver(scene.world).settings;
    Session session(std::move(scene), solver);
    CHECK(returned_of(session).empty());
    REQUIRE_FALSE(session.apply(command::Strike{cue, {1.5, 1.5}}));
    for (int tick = 0; pool_of(session)->is_shooting && tick < 120 * 120; ++tick)
        session.step_forward();
    const auto returned = returned_of(session);
    const auto found = std::ranges::find(returned, black, &PoolAnnotations::Returned::before);
    REQUIRE(found != returned.end());
    CHECK(found->ball != black);
    CHECK(number_of(*pool_of(session), found->ball) == snooker::black);
}
