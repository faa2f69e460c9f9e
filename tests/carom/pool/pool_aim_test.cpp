#include "carom/pool/pool_aim.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "game/commands/aiming.h"
#include "game/referees/referee.h"
#include "game/support/shipped.h"

using namespace carom;

namespace {

Session session_at(Scene scene) {
    const SolverSettings solver = pick_solver(scene.world).settings;
    return Session(std::move(scene), solver);
}

/// The number of the ball that the cue ball meets first as it is aimed now.
std::optional<int> met_by(const PoolAim& aim, const Session& session) {
    const command::Strike strike = aim.strike(session);
    const auto line = aim_line(session.world(), strike.ball, strike.velocity);
    if (!line || !line->object) return std::nullopt;
    return number_of(std::get<PoolPlay>(session.game()), *line->object);
}

}  // namespace

// The pink stands before the triangle, so the nearest red lies hidden behind it.
TEST_CASE("the first aim at the break-off of snooker is at a red, not at the pink before it") {
    const Session session = session_at(test::shipped_level("snooker"));
    const PoolAim aim(session);
    const auto met = met_by(aim, session);
    REQUIRE(met);
    CHECK(may_hit_first(std::get<PoolPlay>(session.game()).rules, *met));
}

// The other player's cue ball lies beside one's own, so it is the nearest ball.
TEST_CASE("the first aim at caroms is at the red, which the break-off has to meet") {
    for (const char* const level : {"three-cushion", "straight-rail", "cushion-caroms"}) {
        CAPTURE(level);
        const Session session = session_at(test::shipped_level(level));
        const command::Strike strike = PoolAim(session).strike(session);
        const auto line = aim_line(session.world(), strike.ball, strike.velocity);
        REQUIRE(line);
        CHECK(line->object == session.world().balls().id[2]);
    }
}

TEST_CASE("in a match the balls in sight come before those that lie hidden, which are named so") {
    Scene scene = test::shipped_level("snooker");
    const Session session = session_at(std::move(scene));
    PoolAim aim(session);
    aim.set_match(true);
    const auto& rules = std::get<PoolPlay>(session.game()).rules;
    bool was_hidden = false;
    int seen = 0;
    for (int i = 0; i < 15; ++i) {
        const std::string text = aim.next_pot(session, false);
        CAPTURE(text);
        const bool is_hidden = text.find(", behind ") != std::string::npos;
        CHECK((is_hidden || !was_hidden));
        const auto met = met_by(aim, session);
        REQUIRE(met);
        if (!is_hidden) CHECK(may_hit_first(rules, *met));
        was_hidden = is_hidden;
        seen += is_hidden ? 0 : 1;
    }
    CHECK(seen >= 1);
    CHECK(seen < 15);
}

// "Full at the 7" was said with the ghost ball on the 1.
TEST_CASE("a key that aims at a ball behind another one names the one that it meets") {
    const Session session = session_at(test::shipped_level("eight-ball"));
    PoolAim aim(session);
    aim.set_match(true);
    int behind = 0;
    for (int i = 0; i < 15; ++i) {
        const std::string text = aim.next_pot(session, false);
        CAPTURE(text);
        const auto met = met_by(aim, session);
        REQUIRE(met);
        CHECK(text.ends_with(fmt::format("the {}", *met)));
        behind += text.find(", behind ") != std::string::npos ? 1 : 0;
    }
    CHECK(behind >= 10);
}

TEST_CASE(
    "in a match the line of the object ball is drawn, and A removes it; in a drill it is not") {
    const Session match = session_at(test::shipped_level("snooker"));
    PoolAim aim(match);
    aim.set_match(true);
    const auto shown = [&](const Session& session) {
        aim.look(session);
        return aim.annotations(session, true);
    };
    CHECK(shown(match).ghost);
    CHECK(shown(match).object);
    CHECK_FALSE(shown(match).tangent);
    CHECK(shown(match).tracks.empty());
    aim.next_aids(match);
    CHECK(shown(match).ghost);
    CHECK_FALSE(shown(match).object);
    aim.next_aids(match);
    CHECK(shown(match).object);
    const Session drill = session_at(test::shipped_level("drill-half-ball"));
    PoolAim drilled(drill);
    drilled.set_match(true);
    drilled.look(drill);
    CHECK(drilled.annotations(drill, true).ghost);
    CHECK_FALSE(drilled.annotations(drill, true).object);
    CHECK(drilled.next_aids(drill) == "For real, only the ghost ball is shown.");
}

// No line was drawn where a ball at the rail is cut along it, which is a common shot.
TEST_CASE("the line of a ball at a cushion runs along the cushion") {
    Scene scene = test::shipped_level("snooker");
    const std::size_t yellow = 16;
    const Vec2 place{0.2, -0.889 + 0.02625};
    scene.world.edit_balls().position[yellow] = place;
    const Session session = session_at(std::move(scene));
    PoolAim aim(session);
    aim.set_match(true);
    aim.look(session);
    aim.aim_at(session, place);
    aim.look(session);
    const PoolAnnotations shown = aim.annotations(session, true);
    REQUIRE(shown.object);
    CHECK(shown.object->to.x > place.x + 5 * 0.02625);
    CHECK(std::abs(shown.object->to.y - place.y) < 0.001);
}

// It ran on through the next ball, so a pot that was blocked looked free.
TEST_CASE("the line of the object ball ends at the next ball") {
    Scene scene = test::shipped_level("snooker");
    const double y = scene.world.balls().position[0].y;
    const double radius = scene.world.balls().radius[0];
    const auto put = [&](std::size_t ball, Vec2 place) {
        scene.world.edit_balls().position[ball] = place;
    };
    put(16, {0.0, y});
    for (const double gap : {0.1, 0.6}) {
        CAPTURE(gap);
        put(17, {gap, y});
        const Session session = session_at(scene);
        PoolAim aim(session);
        aim.set_match(true);
        aim.look(session);
        aim.aim_at(session, {0.0, y});
        aim.look(session);
        const auto line = aim.annotations(session, true).object;
        REQUIRE(line);
        CHECK(line->to.x == doctest::Approx(std::min(gap - 2.0 * radius, 14.0 * radius)));
    }
}

// "cut 36.0 left" was the cut on the 3, before the 2 that was on.
TEST_CASE("the line of the aim names a ball that must not be hit first") {
    const Session session = session_at(test::shipped_level("snooker"));
    PoolAim aim(session);
    aim.set_match(true);
    aim.look(session);
    CHECK(aim.line(session, {}).find(" on ") == std::string::npos);
    const World& world = session.world();
    const BallId pink = *std::get<PoolPlay>(session.game()).balls[20];
    aim.aim_at(session, world.balls().position[*index_of(world, pink)]);
    aim.look(session);
    CHECK(aim.line(session, {}).ends_with("full hit on the pink"));
}

TEST_CASE("aiming lines end at the cushions and in the pockets, not beyond the table") {
    for (const char* const level :
         {"puzzle-02", "puzzle-05", "puzzle-14", "puzzle-17", "eight-ball"}) {
        CAPTURE(level);
        const Session session = session_at(test::shipped_level(level));
        PoolAim aim(session);
        const std::vector<Capsule>& edges = session.world().capsules().shape;
        std::optional<Box> table;
        for (const Capsule& edge : edges)
            table = table ? join(*table, bounds(edge)) : bounds(edge);
        for (int turn = 0; turn < 40; ++turn) {
            aim.turn(9.0);
            aim.look(session);
            const PoolAnnotations shown = aim.annotations(session, true);
            for (const auto& line : {shown.aim, shown.object, shown.tangent}) {
                if (!line) continue;
                CHECK(table->low.x < line->to.x);
                CHECK(line->to.x < table->high.x);
                CHECK(table->low.y < line->to.y);
                CHECK(line->to.y < table->high.y);
            }
        }
    }
}
