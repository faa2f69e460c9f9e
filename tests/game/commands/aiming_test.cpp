#include "game/commands/aiming.h"

#include <cmath>

#include <doctest/doctest.h>

#include "game/ai/pool_shots.h"
#include "game/session/forecast.h"
#include "game/session/session.h"
#include "game/support/shipped.h"
#include "physics/world/fingerprint.h"

using namespace carom;
using carom::test::named;
using carom::test::shipped_level;

namespace {

constexpr double radius = 0.028575;

// The cue ball at 0,0 and one object ball at 1,0 on a table; everything else is the level's.
Scene two_balls() {
    Scene scene = shipped_level("drill-half-ball");
    return scene;
}

}  // namespace

TEST_CASE(
    "a half-ball hit is a cut of 30 degrees, and the tangent is at a right angle to the line of "
    "centres") {
    const Scene scene = two_balls();
    const BallId cue = named(scene, "cue");
    // The cue ball's centre is aimed at the rim of the object ball, which is at 0,0.
    const double apart = 0.9;
    const double slope = radius / std::sqrt(apart * apart - radius * radius);
    const auto line = aim_line(scene.world, cue, {1.0, slope});
    REQUIRE(line);
    REQUIRE(line->object == named(scene, "object"));
    CHECK(line->cut_cosine == doctest::Approx(std::sqrt(0.75)).epsilon(1e-9));
    CHECK(std::abs(dot(line->object_way, line->tangent)) < 1e-12);
    CHECK(length(line->to) == doctest::Approx(2.0 * radius).epsilon(1e-9));
}

TEST_CASE("an aim line that meets no ball ends at a cushion; without a direction there is none") {
    const Scene scene = two_balls();
    const BallId cue = named(scene, "cue");
    const auto line = aim_line(scene.world, cue, {0.0, 3.0});
    REQUIRE(line);
    CHECK_FALSE(line->object);
    CHECK(line->to.y == doctest::Approx(0.635 - radius).epsilon(1e-9));
    CHECK_FALSE(aim_line(scene.world, cue, {}));
    CHECK_FALSE(aim_line(scene.world, BallId{99}, {1.0, 0.0}));
}

TEST_CASE("the forecast of a shot equals the shot, to the last bit") {
    const Scene scene = shipped_level("eight-ball");
    const SolverSettings settings = pick_solver(scene.world).settings;
    Session session(scene, settings);
    const command::Strike strike{
        *std::get<PoolPlay>(session.game()).balls[0], {8.5, 0.1}, 0.2, -0.1};
    Solver solver(settings);
    const Forecast ahead =
        forecast(scene, session.world(), session.game(), solver, strike, 60.0, Tracks::all);
    REQUIRE(ahead.comes_to_rest);
    REQUIRE_FALSE(session.apply(strike));
    while (std::get<PoolPlay>(session.game()).is_shooting)
        session.step_forward();
    CHECK(fingerprint(session.world(), session.game()) == fingerprint(ahead.world, ahead.game));
    CHECK(ahead.first_hit);
    for (const Forecast::Track& track : ahead.tracks) {
        if (track.zone) continue;
        const auto place = index_of(session.world(), track.ball);
        REQUIRE(place);
        CHECK(track.way.back() == session.world().balls().position[*place]);
    }
}

TEST_CASE("the cloth of a 9-ft table is the area between the cushion noses") {
    const auto cloth = cloth_box(shipped_level("nine-ball"));
    REQUIRE(cloth);
    CHECK(cloth->low.x == doctest::Approx(-1.27));
    CHECK(cloth->high.x == doctest::Approx(1.27));
    CHECK(cloth->low.y == doctest::Approx(-0.635));
    CHECK(cloth->high.y == doctest::Approx(0.635));
}

TEST_CASE("the easiest pot of the stop-shot drill is the straight one, and it succeeds") {
    const Scene scene = shipped_level("drill-stop");
    const BallId cue = named(scene, "cue");
    const BallId object = named(scene, "object");
    const auto cloth = cloth_box(scene);
    const Vec2 from = scene.world.balls().position[*index_of(scene.world, cue)];
    const auto lines = pot_lines(scene, scene.world, *cloth, cue, from, std::span(&object, 1));
    REQUIRE_FALSE(lines.empty());
    CHECK(lines.front().way == PotLine::Way::direct);
    CHECK(lines.front().cut_cosine > 0.999);
    Solver solver(pick_solver(scene.world).settings);
    const Forecast ahead = forecast(scene, scene.world, {}, solver,
                                    {cue, lines.front().direction * 2.0}, 60.0, Tracks::none);
    CHECK_FALSE(index_of(ahead.world, object));
}

TEST_CASE("a ball behind another cannot be potted directly") {
    Scene scene = shipped_level("drill-stop");
    const BallId cue = named(scene, "cue");
    const BallId object = named(scene, "object");
    World world = scene.world;
    const Vec2 from = world.balls().position[*index_of(world, cue)];
    const Vec2 there = world.balls().position[*index_of(world, object)];
    add_ball(world, {.kind = world.balls().kind[0], .position = (from + there) * 0.5});
    const auto cloth = cloth_box(scene);
    for (const PotLine& line : pot_lines(scene, world, *cloth, cue, from, std::span(&object, 1)))
        CHECK(line.way == PotLine::Way::kick);
}
