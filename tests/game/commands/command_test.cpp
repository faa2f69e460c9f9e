#include "game/commands/command.h"

#include <doctest/doctest.h>

#include <limits>

#include "game/support/scenes.h"

using namespace carom;
using carom::test::ball_at_rest;
using carom::test::busy_box;
using carom::test::rainy_torus;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

BallSpec of_kind(ClassIndex kind) {
    BallSpec spec;
    spec.kind = kind;
    return spec;
}

BallSpec at(Vec2 place, double radius, double mass, double restitution) {
    return {.kind = 0,
            .position = place,
            .velocity = {},
            .radius = radius,
            .mass = mass,
            .restitution = restitution};
}

struct Refused {
    Command command;
    const char* why;
};

}  // namespace

TEST_CASE("commands that cannot be executed are refused with a reason") {
    const World world = busy_box().world;
    const Refused table[] = {
        {command::Strike{BallId{9}, {}}, "there is no ball 9"},
        {command::Strike{BallId{0}, {0.0, 1.1e18}},
         "the speed is out of range: quantities go up to 1e18"},
        {command::HoldBall{BallId{0}, {1e308, 0.0}},
         "the place is out of range: quantities go up to 1e18"},
        {command::AddBall{at({3.0, 26.0}, 1e-300, 1.0, 1.0)}, "its radius must be in 1e-18..1e18"},
        {command::AddBall{at({3.0, 26.0}, 1.0, 1e300, 1.0)}, "its mass must be in 1e-18..1e18"},
        {command::Strike{BallId{0}, {not_a_number, 0.0}},
         "the speed is out of range: quantities go up to 1e18"},
        {command::HoldBall{BallId{77}, {}}, "there is no ball 77"},
        {command::HoldBall{BallId{0}, {0.0, infinity}},
         "the place is out of range: quantities go up to 1e18"},
        {command::DropBall{BallId{0}}, "ball 0 is not held"},
        {command::HoldCapsule{CapsuleId{7}, {}, {}}, "there is no edge 7"},
        {command::HoldCapsule{CapsuleId{0}, {not_a_number, 0.0}, {}},
         "the place is out of range: quantities go up to 1e18"},
        {command::DropCapsule{CapsuleId{0}}, "edge 0 is not held"},
        {command::PlaceBall{BallId{9}, {}}, "there is no ball 9"},
        {command::PlaceBall{BallId{0}, {13.5, 8.0}}, "Blocked: it would overlap ball 1"},
        {command::PlaceBall{BallId{0}, {29.0, 5.5}}, "Blocked: it would overlap edge 4"},
        {command::PlaceCapsule{CapsuleId{4}, {7.0, 8.0}, {20.0, 8.0}},
         "Blocked: it would overlap ball 0"},
        {command::RemoveBall{BallId{9}}, "there is no ball 9"},
        {command::RemoveCapsule{CapsuleId{7}}, "there is no edge 7"},
        {command::AddBall{of_kind(1)}, "there is no kind 1"},
        {command::AddBall{ball_at_rest({8.0, 9.0})}, "Blocked: it would overlap ball 0"},
        {command::AddBall{ball_at_rest({1.5, 26.0})}, "Blocked: it would overlap edge 3"},
        {command::AddBall{ball_at_rest({not_a_number, 26.0})},
         "the place is out of range: quantities go up to 1e18"},
        {command::AddBall{at({3.0, 26.0}, 0.0, 1.0, 1.0)}, "its radius must be in 1e-18..1e18"},
        {command::AddBall{at({3.0, 26.0}, 1.0, -1.0, 1.0)}, "its mass must be in 1e-18..1e18"},
        {command::AddBall{at({3.0, 26.0}, 1.0, 1.0, 1.5)}, "its restitution must be in 0..1"},
        {command::AddCapsule{{{7.0, 7.0}, {20.0, 7.0}, 0.1}, 0},
         "Blocked: it would overlap ball 0"},
        {command::AddCapsule{{{22.0, 7.0}, {22.0, 9.0}, -1.0}, 0},
         "its radius must not be negative"},
        {command::AddCapsule{{{22.0, 7.0}, {22.0, 9.0}, 0.1}, 3}, "there is no material 3"},
        {command::SetGravity{Vec2{0.0, not_a_number}},
         "gravity is out of range: quantities go up to 1e18"},
        {command::SetSolver{{.kind = SolverKind::substep, .updates = 0}},
         "updates, steps and substeps must be in 1..1000"},
    };
    for (const Refused& row : table) {
        CAPTURE(row.why);
        const auto why = refusal(world, row.command);
        REQUIRE(why);
        CHECK(*why == row.why);
    }
}

// Regression: an edge of side 1e18 on a torus of side 1 took minutes a tick.
TEST_CASE("on a torus no edge may go where balls would not meet all of it") {
    const World world = rainy_torus().world;
    const Box torus = *world.model().wrap;
    const Vec2 in = torus.low + size(torus) * 0.01;
    const Vec2 out = torus.high + size(torus) * 0.8;
    const Refused table[] = {
        {command::AddCapsule{{in, out, 0.0}, 0}, ""},
        {command::PlaceCapsule{CapsuleId{0}, in, out}, ""},
        {command::HoldCapsule{CapsuleId{0}, in, out}, ""},
    };
    for (const Refused& row : table)
        CHECK(refusal(world, row.command) ==
              "the edge would reach too far out of the wrapped world");
    CHECK_FALSE(
        refusal(world, command::HoldCapsule{CapsuleId{0}, in, torus.high + size(torus) * 0.7}));
}

// Regression: fuzzed scene 7662. Gravity drew the balls at rest over the cloth, and no others.
TEST_CASE("a table with a cloth has no other gravity, as in a level") {
    World world = busy_box().world;
    world.edit_definition().model.cloth = Cloth{};
    CHECK(refusal(world, command::SetGravity{Vec2{0.0, -1.0}}) == "A table with a cloth is level");
    CHECK_FALSE(refusal(world, command::SetGravity{}));
}

TEST_CASE("a ball that only touches is not refused") {
    const World world = busy_box().world;
    CHECK_FALSE(refusal(world, command::AddBall{ball_at_rest({2.0, 20.0})}));
    CHECK_FALSE(refusal(world, command::AddBall{ball_at_rest({8.0, 6.0})}));
}

TEST_CASE("overlaps are found across the sides of a torus") {
    World world = rainy_torus().world;
    execute(world, command::AddBall{ball_at_rest({0.5, 27.0})});
    CHECK(refusal(world, command::AddBall{ball_at_rest({39.5, 27.0})}));
    CHECK(refusal(world, command::AddCapsule{{{39.0, 26.0}, {39.0, 28.0}, 1.0}, 0}));
}

TEST_CASE("pairs that do not collide may overlap") {
    World world = busy_box().world;
    world.edit_definition().model.filtered = true;
    world.edit_definition().meets = {0, 1, 1, 0};  // balls collide with edges only
    CHECK_FALSE(refusal(world, command::AddBall{ball_at_rest({8.0, 9.0})}));
    CHECK(refusal(world, command::AddBall{ball_at_rest({1.5, 26.0})}));
}

TEST_CASE("each command has its effect") {
    World world = busy_box().world;
    execute(world, command::Strike{BallId{2}, {1.0, 2.0}});
    CHECK(world.balls().velocity[2] == Vec2{1.0, 2.0});
    execute(world, command::HoldBall{BallId{5}, {1.0, 2.0}});
    execute(world, command::HoldBall{BallId{2}, {3.0, 2.0}});
    execute(world, command::HoldBall{BallId{5}, {4.0, 2.0}});
    REQUIRE(world.held_balls().size() == 2);
    CHECK(world.held_balls()[0].id == BallId{2});
    CHECK(world.held_balls()[1].target == Vec2{4.0, 2.0});
    execute(world, command::DropBall{BallId{2}});
    CHECK(world.held_balls().size() == 1);
    execute(world, command::RemoveBall{BallId{5}});
    CHECK(world.held_balls().empty());
    CHECK(world.balls().size() == 8);
    execute(world, command::SetGravity{Vec2{0.0, -1.0}});
    CHECK(world.model().gravity == Vec2{0.0, -1.0});
    execute(world, command::SetGravity{});
    CHECK_FALSE(world.model().gravity);
}

TEST_CASE("a ball or an edge can be placed where there is room, held or not") {
    World world = busy_box().world;
    // The new position overlaps only the ball's own old one.
    const Command command = command::PlaceBall{BallId{0}, {8.5, 8.0}};
    REQUIRE_FALSE(refusal(world, command));
    execute(world, command::HoldBall{BallId{0}, {1.0, 2.0}});
    execute(world, command);
    CHECK(world.balls().position[0] == Vec2{8.5, 8.0});
    CHECK(world.held_balls()[0].target == Vec2{8.5, 8.0});
    const Command edge = command::PlaceCapsule{CapsuleId{4}, {24.0, 3.0}, {34.0, 6.0}};
    REQUIRE_FALSE(refusal(world, edge));
    execute(world, edge);
    CHECK(world.capsules().shape[4] == Capsule{{24.0, 3.0}, {34.0, 6.0}, 0.5});
}

TEST_CASE("added bodies collide with existing ones, whatever the level contained") {
    World world = busy_box().world;
    world.edit_definition().model.ball_ball = false;
    world.edit_definition().model.ball_edge = false;
    world.edit_balls() = {};
    execute(world, command::AddBall{ball_at_rest({20.0, 15.0})});
    CHECK(world.model().ball_ball);
    CHECK(world.model().ball_edge);
}

TEST_CASE("pairs that cannot collide stay out of the model") {
    World world = busy_box().world;
    world.edit_definition().model.filtered = true;
    world.edit_definition().model.ball_ball = false;
    world.edit_definition().meets = {0, 1, 1, 0};
    execute(world, command::AddBall{ball_at_rest({20.0, 15.0})});
    CHECK_FALSE(world.model().ball_ball);
}

TEST_CASE("strike: an off-centre tip spins the ball, in a model with spin") {
    World world = busy_box().world;
    CHECK(refusal(world, command::Strike{BallId{0}, {1.0, 0.0}, 0.1, 0.0}));
    CHECK(refusal(world, command::Strike{BallId{0}, {1.0, 0.0}, 0.0, 0.1}));
    world.edit_definition().model.spin = 0.4;
    world.edit_definition().model.cloth = Cloth{};
    world.edit_balls().spin.assign(world.balls().size(), 0.0);
    world.edit_balls().roll.assign(world.balls().size(), {});
    CHECK(*refusal(world, command::Strike{BallId{0}, {1.0, 0.0}, 0.3, 0.44}) ==
          "the tip is 0.5325 radii off the middle, and would slip off beyond 0.5");
    const command::Strike strike{BallId{0}, {3.0, 4.0}, 0.2, 0.4};
    CHECK_FALSE(refusal(world, strike));
    execute(world, strike);
    CHECK(world.balls().velocity[0] == Vec2{3.0, 4.0});
    CHECK(world.balls().roll[0] == Vec2{3.0, 4.0});  // at 2/5 it rolls at once
    CHECK(world.balls().spin[0] == doctest::Approx(2.5));
    execute(world, command::Strike{BallId{0}, {1.0, 0.0}});
    CHECK(world.balls().roll[0] == Vec2{});
    CHECK(world.balls().spin[0] == 0.0);
}
