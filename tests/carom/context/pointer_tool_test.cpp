#include "carom/context/pointer_tool.h"

#include <doctest/doctest.h>

#include "game/support/scenes.h"

using namespace carom;
using carom::test::busy_box;

namespace {

Session session() {
    return Session(busy_box(), {.kind = SolverKind::swept});
}

Vec2 ball(const Session& game, std::uint32_t number) {
    return game.world().balls().position[*index_of(game.world(), BallId{number})];
}

}  // namespace

TEST_CASE("a ball is dragged by the point where it was grabbed") {
    Session game = session();
    PointerTool tool;
    REQUIRE(tool.take(game.world(), {8.5, 8.0}, 0.1));
    CHECK(tool.has_ball());
    tool.move(game, {10.0, 8.0}, false);
    tool.prepare(game);
    for (int tick = 0; tick < 30; ++tick)
        game.step_forward();
    CHECK(ball(game, 0).x == doctest::Approx(9.5));
    CHECK(ball(game, 0).y == doctest::Approx(8.0));
    CHECK(tool.open(game) == std::nullopt);
    CHECK(game.world().held_balls().empty());
    CHECK(tool.is_empty());
}

TEST_CASE("holding still logs no commands") {
    Session game = session();
    PointerTool tool;
    REQUIRE(tool.take(game.world(), {8.0, 8.0}, 0.1));
    for (int tick = 0; tick < 50; ++tick) {
        tool.prepare(game);
        game.step_forward();
    }
    CHECK(game.commands().size() == 1);
}

TEST_CASE("in a paused world a ball is placed at the pointer, if there is room") {
    Session game = session();
    PointerTool tool;
    REQUIRE(tool.take(game.world(), {8.0, 8.0}, 0.1));
    CHECK(tool.move(game, {8.0, 5.0}, true) == std::nullopt);
    CHECK(ball(game, 0) == Vec2{8.0, 5.0});
    const auto why_not = tool.move(game, {13.0, 8.5}, true);
    REQUIRE(why_not);
    CHECK(why_not->text == "Blocked: it would overlap ball 1");
    CHECK(why_not->place == game.world().balls().position[1]);
    CHECK(ball(game, 0) == Vec2{8.0, 5.0});
    CHECK(tool.move(game, {5.0, 5.0}, true) == std::nullopt);
    tool.open(game);
    CHECK(ball(game, 0) == Vec2{5.0, 5.0});
    CHECK(game.world().tick() == 0);
}

TEST_CASE("a joint moves as one, or not at all") {
    Session game = session();
    PointerTool tool;
    REQUIRE(tool.take(game.world(), {30.0, 20.0}, 0.1));
    CHECK(tool.has_edges());
    CHECK(tool.move(game, {31.0, 19.0}, true) == std::nullopt);
    CHECK(game.world().capsules().shape[5].end == Vec2{31.0, 19.0});
    CHECK(game.world().capsules().shape[6].start == Vec2{31.0, 19.0});
    REQUIRE(tool.move(game, {18.0, 18.0}, true));  // occupied by a ball
    CHECK(game.world().capsules().shape[5].end == Vec2{31.0, 19.0});
    CHECK(game.world().capsules().shape[6].start == Vec2{31.0, 19.0});
}

TEST_CASE("an edge dragged while time passes reaches the pointer") {
    Session game = session();
    PointerTool tool;
    REQUIRE(tool.take(game.world(), {34.0, 7.0}, 0.1));
    tool.move(game, {34.0, 9.0}, false);
    tool.prepare(game);
    game.step_forward();
    CHECK(game.world().capsules().shape[4].end == Vec2{34.0, 9.0});
    tool.open(game);
    CHECK(game.world().held_capsules().empty());
}

TEST_CASE("the cue shoots away from the pointer, faster for a longer pull") {
    Session game = session();
    PointerTool tool;
    tool.take_cue(BallId{4}, ball(game, 4));
    const Vec2 from = ball(game, 4);
    tool.move(game, from + Vec2{-2.0, -1.0}, true);
    Annotations annotations;
    tool.annotate(game.world(), game.solver(), " m/s", annotations);
    REQUIRE(annotations.cue);
    REQUIRE(annotations.path.size() > 10);
    CHECK(annotations.path[5].x > annotations.path[0].x);
    CHECK(annotations.cue->speed == "11.2 m/s");
    tool.open(game);
    CHECK(game.world().balls().velocity[4] == Vec2{2.0, 1.0} * PointerTool::cue_gain);
}

TEST_CASE("a cancelled cue does not shoot") {
    Session game = session();
    PointerTool tool;
    tool.take_cue(BallId{4}, {0.0, 0.0});
    tool.cancel(game);
    CHECK(tool.is_empty());
    CHECK(game.commands().empty());
}

TEST_CASE("a drawn edge that is refused stays in the tool") {
    Session game = session();
    PointerTool tool;
    tool.start_edge({10.0, 20.5}, 0.1, 0);
    tool.move(game, {18.0, 18.0}, true);
    REQUIRE(tool.open(game));
    CHECK(tool.has_new_edge());
    tool.move(game, {10.0, 26.0}, true);
    CHECK(tool.open(game) == std::nullopt);
    CHECK(tool.is_empty());
    CHECK(game.world().capsules().shape.back() == Capsule{{10.0, 20.5}, {10.0, 26.0}, 0.1});
}

TEST_CASE("objects that the tool does not hold are dropped before time goes on") {
    Session game = session();
    REQUIRE(game.apply(command::HoldBall{BallId{0}, {8.0, 8.0}}) == std::nullopt);
    REQUIRE(game.apply(command::HoldCapsule{CapsuleId{4}, {24, 4}, {34, 7}}) == std::nullopt);
    PointerTool tool;
    tool.prepare(game);
    CHECK(game.world().held_balls().empty());
    CHECK(game.world().held_capsules().empty());
}

TEST_CASE("a ball that vanishes leaves the tool empty") {
    Session game = session();
    PointerTool tool;
    REQUIRE(tool.take(game.world(), {8.0, 8.0}, 0.1));
    REQUIRE(game.apply(command::RemoveBall{BallId{0}}) == std::nullopt);
    CHECK(tool.move(game, {9.0, 9.0}, true) == std::nullopt);
    CHECK(tool.is_empty());
}
