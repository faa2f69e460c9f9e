#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "game/ai/pool_shots.h"
#include "game/commands/aiming.h"
#include "game/support/shipped.h"
#include "game/support/shots_game.h"
#include "geometry/unit.h"

using namespace carom;
using carom::test::named;
using carom::test::shipped_level;
using carom::test::ShotsGame;

namespace {

std::int64_t made(const Scene& scene, const ShotsState& state) {
    REQUIRE(scene.rules.variables.front().name == "made");
    return state.rules.values.front();
}

// Directions to try: at the pots, and at both sides of the ball.
std::vector<Vec2> ways(ShotsGame& game, std::string_view at) {
    const Scene& scene = game.session.scene();
    const World& world = game.session.world();
    const BallId cue = *cue_ball_of(scene, game.state());
    const BallId object = named(scene, at);
    const Vec2 from = world.balls().position[*index_of(world, cue)];
    const Vec2 there = world.balls().position[*index_of(world, object)];
    const double radius = world.balls().radius[*index_of(world, cue)];
    std::vector<Vec2> all;
    const auto cloth = cloth_box(scene);
    REQUIRE(cloth);
    for (const PotLine& line : pot_lines(scene, world, *cloth, cue, from, std::span(&object, 1)))
        all.push_back(line.direction);
    for (const double aside : {1.0, -1.0, 0.9, -0.9, 1.1, -1.1})
        all.push_back(unit(there + perpendicular(unit(there - from)) * (aside * radius) - from));
    return all;
}

// A stroke after which the rules count one more; none is found: nothing.
std::optional<command::Strike> good_stroke(ShotsGame& game, std::string_view at) {
    const Scene& scene = game.session.scene();
    const BallId cue = *cue_ball_of(scene, game.state());
    for (const Vec2 way : ways(game, at))
        for (const double speed : {0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.2, 2.6, 3.0, 4.0})
            for (const double follow : {0.0, -0.1, -0.2, -0.3, -0.4, -0.49}) {
                const command::Strike strike{cue, way * speed, 0.0, follow};
                if (made(scene, game.after(strike)) > made(scene, game.state())) return strike;
            }
    return std::nullopt;
}

}  // namespace

TEST_CASE("drills: what is asked can be done, five times give three stars, a miss counts") {
    struct Drill {
        std::string level;
        const char* at;
        const char* why;  // a soft shot into nothing is a miss
    };
    const char* const up = "Missed: the ball was not pocketed.";
    for (const Drill& drill :
         {Drill{"drill-stop", "object", up}, Drill{"drill-draw", "object", up},
          Drill{"drill-half-ball", "object", "Missed: the first ball was not hit."},
          Drill{"drill-rail", "object", up}}) {
        CAPTURE(drill.level);
        const Scene scene = shipped_level(drill.level);
        CHECK(scene.rules.may_miss);
        ShotsGame game(scene);
        auto strike = good_stroke(game, drill.at);
        REQUIRE(strike);
        for (int attempt = 1; attempt <= 5; ++attempt) {
            strike->ball = *cue_ball_of(scene, game.state());
            game.shoot(*strike);
            CHECK(made(scene, game.state()) == attempt);
        }
        CHECK(game.state().is_over);
        CHECK(stars_of(game.session.game()) == 3);

        REQUIRE_FALSE(game.session.apply(command::RackAgain{}));
        game.session.step_forward();
        game.shoot_softly();
        CHECK(made(scene, game.state()) == 0);
        CHECK(game.state().message == drill.why);
        CHECK(task_text(scene, game.session.world(), game.session.game()) ==
              "TRY 2 OF 5   DONE 0   MISSED 1");
        for (int attempt = 0; attempt < 4; ++attempt) {
            strike->ball = *cue_ball_of(scene, game.state());
            game.shoot(*strike);
        }
        CHECK(stars_of(game.session.game()) == 2);
    }
}

// Straight at the first ball, with these speeds and tips.
TEST_CASE("drills: a miss says why") {
    const auto says = [](const char* level, std::string_view message) {
        ShotsGame game(shipped_level(level));
        const BallId cue = *cue_ball_of(game.session.scene(), game.state());
        for (const Vec2 way : ways(game, "object"))
            for (const double speed : {1.5, 2.5, 3.5})
                for (const double follow : {-0.45, -0.2, 0.0, 0.1, 0.3})
                    if (game.after({cue, way * speed, 0.0, follow}).message == message) return true;
        return false;
    };
    for (const char* const level : {"drill-stop", "drill-draw"}) {
        CAPTURE(level);
        CHECK(says(level, "Missed: the cue ball fell."));
        CHECK(says(level, "Missed: the ball was not pocketed."));
        CHECK(says(level, "Done."));
    }
    CHECK(says("drill-stop", "Missed: pocketed, but the cue ball ran on."));
    CHECK(says("drill-stop", "Missed: pocketed, but the cue ball came back."));
    CHECK_FALSE(says("drill-stop", "Missed: pocketed, but the cue ball ran aside."));
    CHECK(says("drill-draw", "Missed: pocketed, but the cue ball did not reach the other."));
    CHECK(says("drill-half-ball", "Missed: off the first ball, past the third."));
    CHECK(says("drill-rail", "Missed: the ball was not pocketed."));
}

TEST_CASE("drills: of five cuts each pot counts, from where the cue ball stops") {
    ShotsGame game(shipped_level("drill-cuts"));
    const Scene& scene = game.session.scene();
    const auto strike = good_stroke(game, "three");
    REQUIRE(strike);
    game.shoot(*strike);
    CHECK(made(scene, game.state()) == 1);
    CHECK(game.state().message == "Done.");
    const World& world = game.session.world();
    const BallId cue = *cue_ball_of(scene, game.state());
    CHECK(world.balls().position[*index_of(world, cue)] != scene.world.balls().position.back());
    for (int shot = 0; shot < 4; ++shot)
        game.shoot_softly();
    CHECK(game.state().is_over);
    CHECK(stars_of(game.session.game()) == 0);
    CHECK(task_text(scene, game.session.world(), game.session.game()) ==
          "No star with 1: it takes 3");
}
