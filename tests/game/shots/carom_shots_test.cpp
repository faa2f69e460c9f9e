#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "game/support/shipped.h"
#include "game/support/shots_game.h"

// The shots of carom billiards as books describe them, by the order in which the cue ball meets
// cushions and balls: each scores as the rules of its game say.

using namespace carom;
using carom::test::shipped_level;
using carom::test::ShotsGame;

namespace {

// What the cue ball met, in order: c a cushion, 1 the first ball, 2 the other one. What comes after
// the second ball does not matter, nor does the first ball met again.
std::string story_of(ShotsGame& game, const command::Strike& strike) {
    const std::uint32_t cue = number(strike.ball);
    std::string story;
    std::set<std::uint32_t> balls;
    REQUIRE_FALSE(game.session.apply(strike));
    while (game.state().is_shooting) {
        game.session.step_forward();
        for (const Contact& contact : game.session.contacts()) {
            if (balls.size() == 2) continue;
            if (contact.kind == ContactKind::ball_edge) {
                if (contact.a == cue) story += 'c';
                continue;
            }
            if (contact.a != cue && contact.b != cue) continue;
            const std::uint32_t other = contact.a == cue ? contact.b : contact.a;
            if (balls.insert(other).second) story += static_cast<char>('0' + balls.size());
        }
    }
    return story;
}

struct Kinds {
    std::set<std::string> points;
    int misses = 0;
};

// Plays shots all around from the opening position, and checks that a game of so many cushions
// gives a point to those whose story has them before the second ball, and to no others.
Kinds played(const char* level, std::int64_t cushions) {
    Kinds kinds;
    const Scene scene = shipped_level(level);
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
    const Kinds kinds = played("three-cushion", 3);
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
