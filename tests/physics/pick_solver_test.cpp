#include <doctest/doctest.h>

#include <string>

#include "physics/solver.h"
#include "physics/solver_cost.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

SolverKind kind_for(const World& world) {
    return pick_solver(world).settings.kind;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// Inelastic balls in a box of this width, under gravity.
World falling(std::size_t count, double width, double restitution) {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().materials[0].restitution = restitution;
    scenes::add_walls(world, {{0, 0}, {width, width}});
    const auto columns = static_cast<std::size_t>(width / 2.2);
    for (std::size_t i = 0; i < count; ++i)
        add_ball(world, {.position = {1.2 + 2.1 * static_cast<double>(i % columns),
                                      1.5 + 2.1 * static_cast<double>(i / columns)},
                         .radius = 1.0,
                         .restitution = restitution});
    return world;
}

World asked(World world, const Need& need) {
    world.edit_definition().need = need;
    return world;
}

}  // namespace

TEST_CASE("auto takes event where it is both exact and cheap, with or without gravity") {
    CHECK(kind_for(scenes::gas(100, 1)) == SolverKind::event);
    CHECK(kind_for(falling(6, 100.0, 0.7)) == SolverKind::event);  // as in the level `spin`
}

TEST_CASE("auto takes contact for a hopper of 150 balls, not only for 400") {
    CHECK(kind_for(falling(150, 40.0, 0.4)) == SolverKind::contact);
    // Lively balls do not come to rest soon.
    CHECK(kind_for(falling(150, 40.0, 0.99)) == SolverKind::event);
}

// Estimated at 1.4 times the cost of contact, which estimates cannot tell from 1.5.
TEST_CASE("auto takes event only where its cost is below the limit by a margin") {
    CHECK(kind_for(falling(64, 100.0, 0.6)) == SolverKind::contact);
    CHECK(kind_for(falling(40, 100.0, 0.6)) == SolverKind::event);
}

TEST_CASE("auto takes swept where event cannot foresee impacts cheaply") {
    World gas = scenes::gas(100, 1);
    gas.edit_definition().model.drag = 0.1;
    CHECK(kind_for(gas) == SolverKind::swept);
    World door = scenes::gas(400, 1);
    door.edit_definition().model.one_way = true;
    CHECK(kind_for(door) == SolverKind::swept);
}

TEST_CASE("the reason says what else was weighed") {
    const std::string reason = pick_solver(scenes::gas(100, 1)).reason;
    CHECK(has(reason, ". A tick takes about "));
    CHECK(has(reason, "; with contact "));
    CHECK(has(reason, ", swept "));
}

TEST_CASE("a tolerance takes the cheapest solver that keeps it, a budget the most accurate") {
    const World slow = falling(3, 100.0, 1.0);
    const Need brief{.tolerance = 1e-6, .within = 1e-3};
    const World world = asked(slow, brief);
    const SolverPick pick = pick_solver(world);
    CHECK(predicted_error(pick.settings, world, load_of(world), 1e-3) <= 1e-6);
    CHECK(has(pick.reason, "it keeps what the level asks for"));
    CHECK(pick_solver(asked(slow, {.budget = 1.0})).settings.kind == SolverKind::event);
}

TEST_CASE("if nothing keeps what a level asks for, the reason says so") {
    // Chaos grows the rounding of any solver.
    const World gas = scenes::gas(200, 1);
    const SolverPick exact = pick_solver(asked(gas, {.tolerance = 1e-12, .within = 1000.0}));
    CHECK(has(exact.reason, "NOTHING keeps what the level asks for"));
    const SolverPick fast = pick_solver(asked(gas, {.budget = 1e-12}));
    CHECK(fast.settings.kind == SolverKind::discrete);
    CHECK(has(fast.reason, "NOTHING sound keeps the budget"));
}

TEST_CASE("the pick depends on the scene alone") {
    const World world = falling(50, 30.0, 0.6);
    for (int i = 0; i < 3; ++i) {
        const SolverPick pick = pick_solver(world);
        CHECK(pick.settings == pick_solver(World(world)).settings);
        CHECK(pick.reason == pick_solver(World(world)).reason);
    }
}
