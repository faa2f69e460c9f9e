#include "physics/swept/division.h"

#include <doctest/doctest.h>

#include <cmath>

#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/swept/tolerances.h"
#include "physics/tick/totals.h"

using namespace carom;

namespace {

// A lattice of balls of radius 1 in a box, each with this speed, in directions that differ.
World crossing_balls(int across, double speed) {
    World world = scenes::empty();
    world.edit_definition().rate = 60.0;
    const double width = 4.0 * across;
    scenes::add_walls(world, {{0.0, 0.0}, {width, width}});
    for (int i = 0; i < across * across; ++i) {
        const double angle = 2.4 * i;
        add_ball(world, {.position = {4.0 * (i % across) + 2.0, 4.0 * (i / across) + 2.0},
                         .velocity = {speed * std::cos(angle), speed * std::sin(angle)},
                         .radius = 1.0});
    }
    return world;
}

}  // namespace

TEST_CASE("swept: a tick is divided where more than a few balls go far") {
    const double far_speed = swept_tolerance::far * 60.0;  // radii a second, with one substep
    const auto substeps = [](const World& world, int asked) {
        return divide_tick(world, asked).substeps;
    };
    CHECK(substeps(crossing_balls(30, 0.99 * far_speed), 1) == 1);
    CHECK(substeps(crossing_balls(30, 1.1 * far_speed), 1) == 5);
    CHECK(substeps(crossing_balls(30, 1.1 * far_speed), 2) == 2);
    CHECK(substeps(crossing_balls(30, 9.6 * far_speed), 3) == 39);
    CHECK(substeps(crossing_balls(19, 9.5 * far_speed), 1) == 1);  // 361 balls
    const SweptDivision whole = divide_tick(crossing_balls(30, 9.6 * far_speed), 1);
    CHECK(whole.duration == 1.0 / 60.0 / 39.0);
    CHECK(whole.rest == 0.0);
    const SweptDivision cut = divide_tick(crossing_balls(30, 1e12), 1);
    CHECK(cut.substeps == swept_tolerance::most_substeps);
    CHECK(cut.rest == doctest::Approx(1.0 / 60.0));
}

// Regression: balls that crossed the whole scene were candidates of one another, and entered all of
// its cells at each impact, so a tick of 10,000 of them took a minute, uncounted by the budget.
TEST_CASE("swept: balls that cross the whole scene keep their energy, and none gets out") {
    World world = crossing_balls(30, 20'000.0);
    const double energy = totals(world).kinetic_energy;
    Solver solver({.kind = SolverKind::swept});
    for (int i = 0; i < 2; ++i)
        solver.tick(world);
    CHECK(solver.standing().empty());
    CHECK(world.ledger().ball_ball_collisions > 900 * 50);
    CHECK(totals(world).kinetic_energy == doctest::Approx(energy).epsilon(1e-11));
    CHECK(deepest_overlap(world) < 1e-9);
    for (const Vec2 position : world.balls().position) {
        CHECK(position.x == doctest::Approx(60.0).epsilon(1.0));
        CHECK(position.y == doctest::Approx(60.0).epsilon(1.0));
    }
}

TEST_CASE("swept: where no substep is short enough, time stands still for fast balls alone") {
    World world = crossing_balls(30, 1e12);
    const Vec2 calm{100.0, 0.0};
    const std::size_t slow = world.balls().size();
    add_ball(world, {.position = {200.0, 200.0}, .velocity = calm, .radius = 1.0});
    const double energy = totals(world).kinetic_energy;
    Solver solver({.kind = SolverKind::swept});
    solver.tick(world);
    CHECK(solver.standing().size() >= 900);
    CHECK(totals(world).kinetic_energy == doctest::Approx(energy).epsilon(1e-9));
    CHECK(deepest_overlap(world) < 1e-9);
    // This ball is outside of the box, where nothing meets it.
    CHECK(world.balls().position[slow].x == doctest::Approx(200.0 + 100.0 / 60.0));
    CHECK(world.balls().velocity[slow] == calm);
}
