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

TEST_CASE("the hand carries a ball by where it was taken") {
    Session game = session();
    PointerTool hand;
    REQUIRE(hand.take(game.world(), {8.5, 8.0}, 0.1));
    CHECK(hand.has_ball());
    hand.move(game, {10.0, 8.0}, false);
    hand.prepare(game);
    for (int tick = 0; tick < 30; ++tick)
        game.step_forward();
    CHECK(ball(game, 0).x == doctest::Approx(9.5));
    CHECK(ball(game, 0).y == doctest::Approx(8.0));
    CHECK(hand.open(game) == std::nullopt);
    CHECK(game.world().held_balls().empty());
    CHECK(hand.is_empty());
}

TEST_CASE("a hand that rests writes nothing into the log") {
    Session game = session();
    PointerTool hand;
    REQUIRE(hand.take(game.world(), {8.0, 8.0}, 0.1));
    for (int tick = 0; tick < 50; ++tick) {
        hand.prepare(game);
        game.step_forward();
    }
    CHECK(game.commands().size() == 1);
}

TEST_CASE("in a world that stands still a ball is put where the hand is, if there is room") {
    Session game = session();
    PointerTool hand;
    REQUIRE(hand.take(game.world(), {8.0, 8.0}, 0.1));
    CHECK(hand.move(game, {8.0, 5.0}, true) == std::nullopt);
    CHECK(ball(game, 0) == Vec2{8.0, 5.0});
    const auto why_not = hand.move(game, {13.0, 8.5}, true);
    REQUIRE(why_not);
    CHECK(*why_not == "it would overlap ball 1");
    CHECK(ball(game, 0) == Vec2{8.0, 5.0});
    CHECK(hand.move(game, {5.0, 5.0}, true) == std::nullopt);
    hand.open(game);
    CHECK(ball(game, 0) == Vec2{5.0, 5.0});
    CHECK(game.world().tick() == 0);
}

TEST_CASE("a joint is moved as one, or not at all") {
    Session game = session();
    PointerTool hand;
    REQUIRE(hand.take(game.world(), {30.0, 20.0}, 0.1));
    CHECK(hand.has_edges());
    CHECK(hand.move(game, {31.0, 19.0}, true) == std::nullopt);
    CHECK(game.world().capsules().shape[5].end == Vec2{31.0, 19.0});
    CHECK(game.world().capsules().shape[6].start == Vec2{31.0, 19.0});
    REQUIRE(hand.move(game, {18.0, 18.0}, true));  // there is a ball
    CHECK(game.world().capsules().shape[5].end == Vec2{31.0, 19.0});
    CHECK(game.world().capsules().shape[6].start == Vec2{31.0, 19.0});
}

TEST_CASE("an edge that is dragged while time passes gets there") {
    Session game = session();
    PointerTool hand;
    REQUIRE(hand.take(game.world(), {34.0, 7.0}, 0.1));
    hand.move(game, {34.0, 9.0}, false);
    hand.prepare(game);
    game.step_forward();
    CHECK(game.world().capsules().shape[4].end == Vec2{34.0, 9.0});
    hand.open(game);
    CHECK(game.world().held_capsules().empty());
}

TEST_CASE("the cue shoots away from the hand, faster the longer the pull") {
    Session game = session();
    PointerTool hand;
    hand.take_cue(BallId{4}, ball(game, 4));
    const Vec2 from = ball(game, 4);
    hand.move(game, from + Vec2{-2.0, -1.0}, true);
    Marks marks;
    hand.mark(game.world(), game.solver(), " m/s", marks);
    REQUIRE(marks.cue);
    REQUIRE(marks.path.size() > 10);
    CHECK(marks.path[5].x > marks.path[0].x);
    CHECK(marks.cue->speed == "11.2 m/s");
    hand.open(game);
    CHECK(game.world().balls().velocity[4] == Vec2{2.0, 1.0} * PointerTool::cue_gain);
}

TEST_CASE("a cue that is let go does not shoot") {
    Session game = session();
    PointerTool hand;
    hand.take_cue(BallId{4}, {0.0, 0.0});
    hand.cancel(game);
    CHECK(hand.is_empty());
    CHECK(game.commands().empty());
}

TEST_CASE("a drawn edge that is refused stays in the hand") {
    Session game = session();
    PointerTool hand;
    hand.start_edge({10.0, 20.5}, 0.1, 0);
    hand.move(game, {18.0, 18.0}, true);
    REQUIRE(hand.open(game));
    CHECK(hand.has_new_edge());
    hand.move(game, {10.0, 26.0}, true);
    CHECK(hand.open(game) == std::nullopt);
    CHECK(hand.is_empty());
    CHECK(game.world().capsules().shape.back() == Capsule{{10.0, 20.5}, {10.0, 26.0}, 0.1});
}

TEST_CASE("what nobody holds any more is dropped before time goes on") {
    Session game = session();
    REQUIRE(game.apply(command::HoldBall{BallId{0}, {8.0, 8.0}}) == std::nullopt);
    REQUIRE(game.apply(command::HoldCapsule{CapsuleId{4}, {24, 4}, {34, 7}}) == std::nullopt);
    PointerTool hand;
    hand.prepare(game);
    CHECK(game.world().held_balls().empty());
    CHECK(game.world().held_capsules().empty());
}

TEST_CASE("a ball that goes away leaves the hand empty") {
    Session game = session();
    PointerTool hand;
    REQUIRE(hand.take(game.world(), {8.0, 8.0}, 0.1));
    REQUIRE(game.apply(command::RemoveBall{BallId{0}}) == std::nullopt);
    CHECK(hand.move(game, {9.0, 9.0}, true) == std::nullopt);
    CHECK(hand.is_empty());
}
