#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "game/support/carom_table.h"

// Shots of three-cushion that have a name, as they are published: what the books say happens, and
// the point.

using namespace carom;
using carom::test::diamond;
using carom::test::half_width;
using carom::test::in_diamonds;
using carom::test::placed;
using carom::test::shipped_level;
using carom::test::ShotsGame;
using carom::test::struck;
using carom::test::walk_of;

namespace {

// The walks of shots, and whether each scored.
struct Walks {
    std::set<std::string> points;
    std::set<std::string> misses;

    void add(ShotsGame& game, const command::Strike& strike) {
        const std::string walk = walk_of(game, strike);
        CAPTURE(walk);
        const bool is_point = walk.ends_with('2') && walk.size() >= 5;
        CHECK(game.score(0) == (is_point ? 1 : 0));
        (is_point ? points : misses).insert(walk);
    }
    bool any(const std::set<std::string>& walks, const char* beginning) const {
        for (const std::string& walk : walks)
            if (walk.starts_with(beginning)) return true;
        return false;
    }
};

}  // namespace

// E. H. Barry, "System Play: Three-Cushion Billiards" (New York, 1928), figure 1: from one corner
// to the third diamond of the other long rail, with running side of about the width of the tip, the
// cue ball leaves the second long rail at its second diamond, and arrives in the far corner.
TEST_CASE("three-cushion: from corner to corner around the table by the third diamond") {
    constexpr double behind = 0.09;  // the diamonds lie behind the noses
    const Vec2 corner = in_diamonds(0.0, 0.0) - Vec2{behind, behind};
    const Vec2 way = in_diamonds(5.0, 4.0) + Vec2{0.0, behind} - corner;
    const Vec2 start = corner + way * (0.4 / std::hypot(way.x, way.y));
    ShotsGame game(placed({start, in_diamonds(4.0, 2.0), in_diamonds(4.2, 2.0)}));
    REQUIRE_FALSE(game.session.apply(struck(game, way, 4.0, 0.3)));
    std::vector<Vec2> cushions;
    while (game.state().is_shooting && cushions.size() < 4) {
        game.session.step_forward();
        for (const Contact& contact : game.session.contacts())
            if (contact.kind == ContactKind::ball_edge) cushions.push_back(contact.point);
    }
    REQUIRE(cushions.size() == 4);
    CHECK(cushions[2].y == doctest::Approx(-half_width));
    CHECK(std::abs(cushions[2].x - in_diamonds(6.0, 0.0).x) < 0.4 * diamond);
    const Vec2 from_corner = cushions[3] - in_diamonds(0.0, 4.0);
    CHECK(std::hypot(from_corner.x, from_corner.y) < 0.6 * diamond);
}

// "3 Cushion Billiards Break Shot" (basicbilliards.com): a third to a half of the far side of the
// red, high, with inside English; three rails into the second ball.
TEST_CASE("three-cushion: the opening shot scores with inside English, and not with outside") {
    const Scene scene = shipped_level("three-cushion");
    const Vec2 white = scene.world.balls().position[0];
    const Vec2 there = scene.world.balls().position[2] - white;
    const double reach = 2.0 * scene.world.balls().radius[0] / std::hypot(there.x, there.y);
    // Past the red on its far side the object ball goes to the right: inside is right.
    const auto walks = [&](double side) {
        Walks all;
        for (const double full : {1.0 / 3.0, 0.4, 0.45, 0.5})
            for (const double follow : {0.2, 0.3})
                for (const double speed : {4.0, 4.5}) {
                    ShotsGame game(scene);
                    const double turn =
                        std::atan2(there.y, there.x) + std::asin(reach * (1.0 - full));
                    all.add(game,
                            struck(game, {std::cos(turn), std::sin(turn)}, speed, side, follow));
                }
        return all;
    };
    const Walks inside = walks(0.3);
    CHECK(inside.points.contains("1nes2"));  // long, short, long
    // Around the table: with both short rails (glossary of the BCA rules, kelowna8ball.ca).
    CHECK(inside.points.contains("1nesw2"));
    CHECK(walks(-0.3).points.empty());
}

// "Tickie" (billiardsvault.com): off a rail at a ball, and back to the same rail.
TEST_CASE("three-cushion: a tickie meets a rail, a ball and the same rail again, and scores") {
    Walks walks;
    const double radius = 0.03075;
    for (double target = 5.6; target < 5.95; target += 0.02) {
        // A slot of 50 mm between the red and the rail.
        const Vec2 red = in_diamonds(6.0, 4.0) - Vec2{0.0, radius + 0.05};
        ShotsGame game(placed({in_diamonds(3.0, 2.0), in_diamonds(7.0, 1.0), red}));
        const Vec2 way = in_diamonds(target, 4.0) - Vec2{0.0, radius} - in_diamonds(3.0, 2.0);
        walks.add(game, struck(game, way, 5.5, 0.45));
    }
    CHECK(walks.any(walks.points, "n1n"));
    CHECK(walks.any(walks.misses, "n1n"));
}

// "Double the rail", or snake (billiardsvault.com): down a rail at a shallow angle with reverse
// English, which turns the ball off the adjacent rail back into the first one.
TEST_CASE("three-cushion: reverse English doubles the rail, and scores") {
    Walks doubled;
    for (const double side : {-0.45, 0.0, 0.45})
        for (const double from : {0.4, 0.6})
            for (double target = 6.4; target < 7.5; target += 0.1) {
                ShotsGame game(
                    placed({in_diamonds(4.0, from), in_diamonds(3.0, 0.8), in_diamonds(3.2, 1.0)}));
                const Vec2 way =
                    in_diamonds(target, 0.0) + Vec2{0.0, 0.03075} - in_diamonds(4.0, from);
                Walks one;
                one.add(game, struck(game, way, 4.0, side));
                CAPTURE(side);
                const bool is_double = one.any(one.points, "ses") || one.any(one.misses, "ses");
                // Along the lower rail to the right, English on the right is reverse.
                CHECK(is_double == (side > 0.0));
                if (is_double) doubled.points.merge(one.points);
            }
    CHECK(doubled.points.contains("ses12"));
}
