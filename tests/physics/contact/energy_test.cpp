#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "physics/contact/contact_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/support/shaft.h"
#include "physics/tick/totals.h"

// Shafts and columns of lively balls, whatever falls on what: constraints give back no more than
// they took (contact/energy.h).

using namespace carom;

namespace {

// The most by which the energy rises above what it was before, as shares of that at the start.
struct Rises {
    double of_balls = 0.0;
    double with_springs = 0.0;  // the energy that the constraints store counted, too
};

Rises most_rises(std::uint64_t number, double seconds) {
    World world = scenes::shaft(number);
    Solver solver({.kind = SolverKind::contact});
    // Potential energy is 0 at the floor, which is at a height of 0.
    const auto of_balls = [&] {
        const Totals now = totals(world);
        return now.kinetic_energy + now.potential_energy;
    };
    const double start = of_balls();
    double least = start;
    double least_with_springs = start;
    Rises rises;
    for (int tick = 0; tick < static_cast<int>(seconds * world.rate()); ++tick) {
        solver.tick(world);
        const double energy = of_balls();
        const double springs = std::max(0.0, contact_memory(world).stored_energy);
        rises.of_balls = std::max(rises.of_balls, (energy - least) / start);
        rises.with_springs =
            std::max(rises.with_springs, (energy + springs - least_with_springs) / start);
        least = std::min(least, energy);
        least_with_springs = std::min(least_with_springs, energy + springs);
    }
    return rises;
}

void check_shafts(std::uint64_t first, std::uint64_t last, double seconds, double of_balls) {
    Rises worst;
    for (std::uint64_t number = first; number < last; ++number) {
        CAPTURE(number);
        const Rises rises = most_rises(number, seconds);
        worst.of_balls = std::max(worst.of_balls, rises.of_balls);
        worst.with_springs = std::max(worst.with_springs, rises.with_springs);
        CHECK(rises.of_balls < of_balls);
        CHECK(rises.with_springs < 0.005);
    }
    MESSAGE("energy above its own minimum, at most " << worst.of_balls << " of that at the start; "
                                                     << worst.with_springs << " with springs");
}

}  // namespace

// Regression: columns under a load sank in, and threw it up again; of 1,500 shafts 165 gained more
// than a hundredth of their energy, and one 2.8 times that.
TEST_CASE("contact: shafts and columns of lively balls do not gain their energy back") {
    for (const std::uint64_t number :
         {2, 61, 132, 157, 355, 376, 449, 540, 926, 1213, 1438, 1448}) {
        CAPTURE(number);
        CHECK(most_rises(number, 6.0).of_balls < 0.01);
    }
    check_shafts(0, 60, 6.0, 0.01);
}

// Regression: balls that start in one place gained hundreds of times their energy.
TEST_CASE("contact: coincident balls gain no energy") {
    for (const double height : {0.5, 5.0}) {
        CAPTURE(height);
        World world = scenes::empty();
        world.edit_definition().rate = 60.0;
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().model.inelastic = true;
        world.edit_definition().kinds = {{.radius = 0.5, .mass = 1.0, .restitution = 0.3}};
        world.edit_definition().materials = {{.restitution = 0.3}};
        add_capsule(world, {{-20.0, 0.0}, {20.0, 0.0}, 0.0}, 0);
        for (int i = 0; i < 60; ++i)
            add_ball(world, {.position = {0.0, height}});
        Solver solver({.kind = SolverKind::contact});
        const double start = totals(world).potential_energy;
        for (int tick = 0; tick < 90; ++tick) {
            solver.tick(world);
            const Totals now = totals(world);
            CHECK(now.kinetic_energy + now.potential_energy < 1.01 * start);
        }
    }
}

// Regression: what opens the overlap of the lower ball throws the upper one off, so that they press
// on one another no longer when the substep ends. Then nothing took back what it had gained.
TEST_CASE("contact: a ball that comes out of an edge does not throw the ball on it") {
    constexpr double gravity = 20.0;
    for (int place = 0; place < 40; ++place) {
        CAPTURE(place);
        World world = scenes::empty();
        world.edit_definition().rate = 120.0;
        world.edit_definition().model.gravity = Vec2{0.0, -gravity};
        world.edit_definition().model.inelastic = true;
        world.edit_definition().materials = {{.restitution = 0.0}};
        add_capsule(world, {{-20.0, 0.0}, {20.0, 0.0}, 0.0}, 0);
        const Vec2 sunk{0.0, 0.1};
        const Vec2 aside{-0.05 * place, 2.0};
        const Vec2 away = aside * (2.0 / length(aside));
        add_ball(world, {.position = sunk});
        add_ball(world, {.position = sunk + away});
        Solver solver({.kind = SolverKind::contact});
        const double at_start = gravity * (2.0 * sunk.y + away.y);
        for (int tick = 0; tick < 30; ++tick) {
            solver.tick(world);
            const Totals now = totals(world);
            CHECK(now.kinetic_energy + now.potential_energy < 1.01 * at_start);
        }
    }
}

TEST_SUITE("long") {
    TEST_CASE("contact: 2,000 shafts and columns do not gain their energy back") {
        // Number 527 reaches 1.12 % (docs/accuracy.md).
        check_shafts(0, 2000, 6.0, 0.012);
    }
}
