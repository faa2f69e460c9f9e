#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "game/support/carom_table.h"

// The shots of carom billiards as books describe them, by the order in which the cue ball meets
// cushions and balls: each scores as the rules of its game say.

using namespace carom;
using carom::test::in_diamonds;
using carom::test::placed;
using carom::test::shipped_level;
using carom::test::ShotsGame;
using carom::test::story_of;
using carom::test::struck;

namespace {

struct Kinds {
    std::set<std::string> points;
    int misses = 0;
};

// Plays shots all around from the opening position, and checks that a game of so many cushions
// gives a point to those whose story has them before the second ball, and to no others.
Kinds played(const char* level, std::int64_t cushions, std::vector<std::string> changes = {}) {
    Kinds kinds;
    const Scene scene = shipped_level(level, changes);
    for (int degrees = 0; degrees < 360; ++degrees) {
        ShotsGame game(scene);
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        const BallId white = *cue_ball_of(scene, game.state());
        const std::string story =
            story_of(game, {white, {6.0 * std::cos(angle), 6.0 * std::sin(angle)}});
        const std::size_t second = story.find('2');
        const bool is_point =
            second != std::string::npos && std::count(story.begin(), story.end(), 'c') >= cushions;
        CAPTURE(degrees);
        CAPTURE(story);
        CHECK(game.score(0) == (is_point ? 1 : 0));
        CHECK(game.state().rules.player == (is_point ? 0u : 1u));
        if (is_point)
            kinds.points.insert(story);
        else
            ++kinds.misses;
    }
    return kinds;
}

bool has_story(const Kinds& kinds, const char* beginning) {
    for (const std::string& story : kinds.points)
        if (story.starts_with(beginning)) return true;
    return false;
}

}  // namespace

TEST_CASE("three-cushion: natural, rail-first, umbrella and bank shots score, and nothing else") {
    const Kinds kinds = played("three-cushion", 3, {"let opening=0"});
    CHECK(has_story(kinds, "1ccc"));   // natural: a ball, three cushions, the other ball
    CHECK(has_story(kinds, "c1cc"));   // rail first
    CHECK(has_story(kinds, "cc1c"));   // umbrella: two cushions, a ball, a third cushion
    CHECK(has_story(kinds, "ccc12"));  // bank shot: three cushions, then both balls
    CHECK(kinds.misses > 0);
}

// The opening position: red on the foot spot, the other ball on the head spot, the cue ball 182.5
// mm beside it. The opening shot of the books is a natural: off the red, with three cushions on the
// way to the other ball.
TEST_CASE("three-cushion: the opening shot scores off the red, by three cushions") {
    const Scene scene = shipped_level("three-cushion");
    const Vec2 white = scene.world.balls().position[0];
    const Vec2 yellow = scene.world.balls().position[1];
    const Vec2 red = scene.world.balls().position[2];
    CHECK(white.x == yellow.x);
    CHECK(yellow.y - white.y == doctest::Approx(0.1825));
    CHECK(red.x == -yellow.x);
    const Vec2 there = red - white;
    const double reach = 2.0 * scene.world.balls().radius[0] / std::hypot(there.x, there.y);
    std::set<std::string> stories;
    for (int tenths = -18; tenths <= 18; ++tenths)
        for (const double speed : {3.0, 4.0, 5.0})
            for (const double side : {-0.4, 0.0, 0.4}) {
                ShotsGame game(scene);
                // A hit of the red from its edge on one side to its edge on the other.
                const double turn = std::atan2(there.y, there.x) + std::asin(reach * tenths / 20.0);
                const std::string story =
                    story_of(game, {*cue_ball_of(scene, game.state()),
                                    {speed * std::cos(turn), speed * std::sin(turn)},
                                    side});
                if (!story.starts_with('1') || story.back() != '2') continue;
                CAPTURE(story);
                CHECK(game.score(0) == (story.size() >= 5 ? 1 : 0));
                stories.insert(story);
            }
    CHECK(std::ranges::any_of(stories,
                              [](const std::string& story) { return story.starts_with("1ccc"); }));
}

// World rules of carom billiards (UMB), "Starting position": by direct attack on the red ball.
TEST_CASE("three-cushion: the first shot of a game scores only straight off the red") {
    const auto strikes = [](const ShotsGame& game) {
        std::vector<command::Strike> all;
        for (int degrees = 0; degrees < 360; ++degrees) {
            const double angle = degrees * 3.14159265358979323846 / 180.0;
            all.push_back(struck(game, {std::cos(angle), std::sin(angle)}, 6.0, 0.0));
        }
        return all;
    };
    ShotsGame game(shipped_level("three-cushion"));
    ShotsGame free(shipped_level("three-cushion", {"let opening=0"}));
    int astray = 0;
    for (const command::Strike& strike : strikes(game)) {
        const ShotsState after = game.after(strike);
        if (after.players[0].score > 0) continue;
        CHECK(after.rules.player == 1);
        if (free.after(strike).players[0].score == 0) continue;
        CHECK(after.message == "No point: the first shot goes straight at the red.");
        ++astray;
    }
    CHECK(astray > 0);
    // Any later shot is free: the second player's first one, too.
    game.shoot_softly();
    int points = 0;
    for (const command::Strike& strike : strikes(game)) {
        const ShotsState after = game.after(strike);
        CHECK(after.message.find("first shot") == std::string::npos);
        points += after.players[1].score > 0;
    }
    CHECK(points > 0);
}

// "The Diamond System" (E. Perreault with the Billard Club Sottevillais): aim = start - finish,
// with running side and the tip on the equator. The start is 50, the corner; the aim counts ten a
// diamond along the first long rail from its far end, the finish along the other from there. Lines
// go through the diamonds, 90 mm behind the noses, and a finish faces its diamond at the nose.
TEST_CASE("three-cushion: the diamond system finds the third cushion within 0.6 diamonds") {
    constexpr double behind = 0.09;
    for (const double aim : {20.0, 25.0, 30.0, 35.0, 40.0}) {
        const double finish = 50.0 - aim;
        CAPTURE(aim);
        const Vec2 corner = in_diamonds(0.0, 0.0) - Vec2{behind, behind};
        const Vec2 target = in_diamonds(8.0 - aim / 10.0, 4.0) + Vec2{0.0, behind};
        const Vec2 way = target - corner;
        const Vec2 start = corner + way * (0.4 / std::hypot(way.x, way.y));
        ShotsGame game(placed({start, in_diamonds(0.5, 3.6), in_diamonds(1.2, 3.6)}));
        REQUIRE_FALSE(game.session.apply(struck(game, way, 4.0, 0.3)));
        std::vector<Vec2> cushions;
        while (game.state().is_shooting && cushions.size() < 3) {
            game.session.step_forward();
            for (const Contact& contact : game.session.contacts())
                if (contact.kind == ContactKind::ball_edge) cushions.push_back(contact.point);
        }
        REQUIRE(cushions.size() >= 3);
        CHECK(cushions[0].y == doctest::Approx(0.71));
        CHECK(cushions[1].x == doctest::Approx(1.42));
        CHECK(cushions[2].y == doctest::Approx(-0.71));
        const double reached = (in_diamonds(8.0, 0.0).x - cushions[2].x) / 0.355 * 10.0;
        CHECK(std::abs(reached - finish) < 6.0);
    }
}

// A worked example of the same system, from the exercises that came with Pool.ma, a notebook for
// Mathematica: from 2,2 towards 4.5 on the south cushion, the cue ball meets balls at 5,3 and
// 5,2.5.
TEST_CASE("three-cushion: a shot of the diamond system scores by three cushions first") {
    ShotsGame game(placed({in_diamonds(2.0, 2.0), in_diamonds(5.0, 3.0), in_diamonds(5.0, 2.5)}));
    const Vec2 way = in_diamonds(4.5, 0.0) - in_diamonds(2.0, 2.0);
    CHECK(story_of(game, struck(game, way, 4.0, -0.3)) == "ccc12");
    CHECK(game.score(0) == 1);
    CHECK(game.state().rules.player == 0);
    CHECK(game.state().message == "3 cushions: a point.");
}

// From the same place, by the short way off one cushion: both balls are hit, and it is no point.
TEST_CASE("three-cushion: both balls by fewer cushions is no point, and says why") {
    ShotsGame game(placed({in_diamonds(2.0, 2.0), in_diamonds(5.0, 2.02), in_diamonds(7.0, 2.0)}));
    bool is_met = false;
    for (int degrees = -20; degrees <= 20 && !is_met; ++degrees) {
        const double angle = 0.1 * degrees * 3.14159265358979323846 / 180.0;
        const command::Strike strike = struck(game, {std::cos(angle), std::sin(angle)}, 5.0, 0.0);
        const ShotsState after = game.after(strike);
        is_met = after.message.starts_with("No point: ") &&
                 after.message.ends_with(" before the second ball.");
        if (is_met) CHECK(after.players[0].score == 0);
    }
    CHECK(is_met);
}

TEST_CASE("cushion caroms: one cushion anywhere before the second ball is enough") {
    const Kinds kinds = played("cushion-caroms", 1);
    CHECK(has_story(kinds, "1c"));
    CHECK(has_story(kinds, "c"));
    CHECK(kinds.misses > 0);
}

TEST_CASE("straight rail: no cushion is needed") {
    const Kinds kinds = played("straight-rail", 0);
    CHECK(has_story(kinds, "1"));
    CHECK(kinds.misses > 0);
}
