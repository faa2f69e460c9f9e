#include "game/ai/daily_shot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "game/support/shipped.h"
#include "game/support/shots_game.h"

using namespace carom;
using carom::test::shipped_level;
using carom::test::ShotsGame;

TEST_CASE("the shot of the day can be made, on each of forty days, and each is another") {
    const Scene base = shipped_level("shot-of-the-day");
    std::set<std::string> seen;
    for (int day = 0; day < 40; ++day) {
        const int date = 20260101 + 100 * (day % 12) + day / 2;
        CAPTURE(date);
        const auto shot = daily_shot(base, date);
        REQUIRE(shot);
        const std::vector<std::string> lines = amendments_of(*shot, date);
        std::string all;
        for (const std::string& line : lines)
            all += line.substr(line.find("let day") == 0 ? line.size() : 0) + "\n";
        CHECK(seen.insert(all).second);
        const Scene scene = shipped_level("shot-of-the-day", lines);
        ShotsGame game(scene);
        command::Strike strike = shot->example;
        strike.ball = *cue_ball_of(scene, game.state());
        game.shoot(strike);
        CHECK(stars_of(game.session.game()) == 3);
        CHECK(game.state().is_over);
    }
}

TEST_CASE("the shot of the day depends on the date and the level alone") {
    const Scene base = shipped_level("shot-of-the-day");
    const auto one = daily_shot(base, 20260214);
    const auto again = daily_shot(base, 20260214);
    REQUIRE(one);
    REQUIRE(again);
    CHECK(amendments_of(*one, 20260214) == amendments_of(*again, 20260214));
    CHECK(one->example.velocity == again->example.velocity);
    // Where it stands on the table of another date does not matter.
    const Scene moved = shipped_level("shot-of-the-day", amendments_of(*one, 20260214));
    const auto from_there = daily_shot(moved, 20260214);
    REQUIRE(from_there);
    CHECK(amendments_of(*from_there, 20260214) == amendments_of(*one, 20260214));
    CHECK_FALSE(daily_shot(shipped_level("galton"), 20260214));
}

TEST_CASE("the shot of the day: three tries, and each sets the balls up again") {
    const Scene scene = shipped_level("shot-of-the-day");
    ShotsGame game(scene);
    for (int attempt = 1; attempt <= 3; ++attempt) {
        CHECK_FALSE(game.state().is_over);
        game.shoot({-0.3, 0.1});
        CHECK(game.state().message == "The ball was not pocketed.");
        const World& world = game.session.world();
        for (std::size_t ball = 0; ball < 2; ++ball)
            CHECK(world.balls().position[*index_of(world, *game.state().balls[ball])] ==
                  scene.world.balls().position[ball]);
    }
    CHECK(game.state().is_over);
    CHECK(stars_of(game.session.game()) == 0);
}
