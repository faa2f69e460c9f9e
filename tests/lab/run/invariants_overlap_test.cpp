#include <doctest/doctest.h>

#include <optional>

#include "lab/run/invariants.h"
#include "physics/solver.h"

// Which overlaps count, where a solver lifts bodies apart that started inside one another.

using namespace carom;

namespace {

// Balls 0 and 1 start deep inside one another. Balls 2 and 3 lie apart from them and from one
// another.
Scene two_pairs() {
    Scene scene;
    World& world = scene.world;
    world.edit_definition().kinds = {{}};
    for (const double x : {0.0, 0.5, 10.0, 20.0})
        add_ball(world, {.position = {x, 0.0}});
    return scene;
}

// What is found if, in one tick, ball `moved` gets inside ball `into`.
std::optional<Breach> found(SolverKind solver, double distance, std::size_t moved,
                            std::size_t into) {
    const Scene scene = two_pairs();
    InvariantCheck check(scene, solver);
    World world = scene.world;
    Balls& balls = world.edit_balls();
    balls.position[1] = balls.position[0] + Vec2{distance, 0.0};
    ++world.edit_tick();
    REQUIRE(!check.note_tick(world, true));
    balls.position[moved] = balls.position[into] + Vec2{0.0, 0.5};
    ++world.edit_tick();
    return check.note_tick(world, true);
}

}  // namespace

// Regression: a ball that was lifted out of another was pressed into a third one, and the run was
// said to break its promise about overlap.
TEST_CASE("invariants: what is lifted out of one body may be pressed into another") {
    CHECK(!found(SolverKind::contact, 0.6, 2, 1));
    CHECK(!found(SolverKind::event, 0.6, 2, 1));
    // One that has nearly come out presses no longer.
    CHECK(found(SolverKind::contact, 1.5, 2, 1));
    CHECK(found(SolverKind::event, 1.5, 2, 1));
    // `swept` lifts nothing, and other balls are not exempt.
    CHECK(found(SolverKind::swept, 0.6, 2, 1));
    for (const SolverKind solver : {SolverKind::contact, SolverKind::event})
        CHECK(found(solver, 0.6, 3, 2));
}

TEST_CASE("invariants: a pair that was pressed together counts again once it has separated") {
    const Scene scene = two_pairs();
    InvariantCheck check(scene, SolverKind::contact);
    World world = scene.world;
    Balls& balls = world.edit_balls();
    const auto tick = [&](double of_first, double of_second) {
        balls.position[1] = balls.position[0] + Vec2{of_first, 0.0};
        balls.position[2] = balls.position[1] + Vec2{of_second, 0.0};
        ++world.edit_tick();
        return check.note_tick(world, true);
    };
    CHECK(!tick(0.6, 0.5));
    CHECK(!tick(2.1, 1.9));
    CHECK(!tick(2.1, 0.5));
    CHECK(!tick(2.1, 2.1));
    const auto breach = tick(2.1, 0.5);
    REQUIRE(breach);
    CHECK(breach->kind == Breach::Kind::overlap);
}
