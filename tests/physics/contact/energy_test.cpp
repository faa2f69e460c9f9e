#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "physics/contact/contact_memory.h"
#include "physics/solver.h"
#include "physics/support/dice.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"

// Shafts and columns of lively balls, whatever falls on what: constraints give back no more than
// they took (contact/energy.h).

using namespace carom;

namespace {

template <std::size_t N>
double one_of(Dice& dice, const double (&values)[N]) {
    return values[dice.below(static_cast<int>(N))];
}

// A shaft, or a wider bin, in which a column falls or lies: masses up to 1,000 times apart.
World shaft(std::uint64_t number) {
    Dice dice{number * 0x2545f4914f6cdd1du + 777};
    World world = scenes::empty();
    Model& model = world.edit_definition().model;
    model.gravity = Vec2{0.0, -10.0};
    const double restitution = one_of(dice, {0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0});
    const double of_edge =
        dice.chance(0.5) ? restitution : one_of(dice, {0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0});
    model.inelastic = restitution < 1.0 || of_edge < 1.0;
    if (dice.chance(0.25)) model.spin = 0.5;
    const double friction = dice.between(0.05, 0.8);
    world.edit_definition().rate = one_of(dice, {60.0, 120.0, 240.0, 500.0, 1000.0});
    world.edit_definition().kinds = {
        {.radius = 1.0, .mass = 1.0, .restitution = restitution, .friction = friction}};
    world.edit_definition().materials = {{.restitution = of_edge, .friction = friction}};
    const double wide = one_of(dice, {2.0001, 2.1, 2.5, 3.2, 3.9, 4.2, 6.0, 8.5});
    const auto count = static_cast<std::size_t>(3 + dice.below(dice.chance(0.3) ? 60 : 14));
    const double ratio = dice.chance(0.3) ? 1.0 : dice.scaled(2.0, 1000.0);
    const int pattern = dice.below(5);
    const double gap = dice.chance(0.3) ? 0.0 : dice.scaled(1e-6, 3.0);
    const double drop = dice.chance(0.5) ? 0.0 : dice.between(0.0, 8.0);
    const double shake = dice.chance(0.4) ? 0.0 : dice.scaled(1e-6, 2.0);
    const double spread = dice.chance(0.6) ? 0.0 : 0.3;
    add_capsule(world, {{-1.0, -1.0}, {wide + 1.0, -1.0}, 1.0}, 0);
    add_capsule(world, {{-1.0, -1.0}, {-1.0, 800.0}, 1.0}, 0);
    add_capsule(world, {{wide + 1.0, -1.0}, {wide + 1.0, 800.0}, 1.0}, 0);
    const auto columns = static_cast<std::size_t>(wide / 2.0);
    double y = drop;
    for (std::size_t i = 0; i < count; y += gap) {
        double top = 0.0;
        for (std::size_t column = 0; column < columns && i < count; ++column, ++i) {
            double mass = 1.0;
            if (pattern == 1 && i + columns >= count) mass = ratio;  // on top
            if (pattern == 2 && i % 2 == 1) mass = ratio;            // alternating
            if (pattern == 3 && i < columns) mass = ratio;           // below
            if (pattern == 4) mass = dice.scaled(1.0, std::max(1.0001, ratio));
            const double radius = 1.0 - (spread > 0.0 ? dice.between(0.0, spread) : 0.0);
            const double cell = wide / static_cast<double>(columns);
            const double slack = std::max(0.0, cell / 2 - radius);
            double x = cell * (static_cast<double>(column) + 0.5);
            if (dice.chance(0.7)) x += slack * dice.between(-1.0, 1.0);
            const Vec2 velocity{dice.between(-shake, shake), dice.between(-shake, shake)};
            add_ball(world, {.position = {x, y + radius},
                             .velocity = velocity,
                             .radius = radius,
                             .mass = mass});
            top = std::max(top, 2.0 * radius);
        }
        y += top;
    }
    return world;
}

// The most by which the energy rises above what it was before, as shares of that at the start.
struct Rises {
    double of_balls = 0.0;
    double with_springs = 0.0;  // the energy that the constraints store counted, too
};

Rises most_rises(std::uint64_t number, double seconds) {
    World world = shaft(number);
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
