#include "game/session/predict.h"

#include <doctest/doctest.h>

#include "game/session/session.h"
#include "game/support/scenes.h"

using namespace carom;
using carom::test::busy_box;

TEST_CASE("a predicted path is exact, bit by bit") {
    const SolverSettings solver{.kind = SolverKind::swept};
    Session session(busy_box(), solver);
    for (int tick = 0; tick < 37; ++tick)
        session.step_forward();
    const auto path = predicted_path(session.world(), solver, BallId{4}, {60.0, 45.0}, 300);
    REQUIRE(path.size() == 301);
    REQUIRE(session.apply(command::Strike{BallId{4}, {60.0, 45.0}}) == std::nullopt);
    for (const Vec2 place : path) {
        REQUIRE(session.world().balls().position[4] == place);
        session.step_forward();
    }
}

TEST_CASE("a prediction ends when its ball is removed") {
    const SolverSettings solver{.kind = SolverKind::swept};
    World world = busy_box().world;
    CHECK(predicted_path(world, solver, BallId{99}, {}, 10).empty());
    Zone sink{{{0.0, 15.0}, {40.0, 15.0}, 30.0}, Zone::Effect::sink, 0};
    world.edit_definition().zones = {sink};
    world.edit_ledger().counters = {0};
    CHECK(predicted_path(world, solver, BallId{4}, {}, 10).size() == 1);
}
