#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/random.h"

// Motorised edges, which throw what they meet as a moving wall does. An impact that takes the edge
// for one that stands still shows in the energy of a gas under a piston, and in an invariant of one
// ball that is exact.

using namespace carom;

namespace {

constexpr double radius = 0.05;

// A ball between a wall at 0 and a piston at 10.1, which comes at `speed`. Both walls are
// thin. The free width is that between the two places of the ball's centre at which it touches one.
struct Piston {
    World world = scenes::empty();
    CapsuleId piston{};
    double start = 10.0 + 2.0 * radius;
    double speed = 0.1;

    explicit Piston(double rate) {
        world.edit_definition().rate = rate;
        add_capsule(world, {{0.0, -5.0}, {0.0, 5.0}, 0.0}, 0);
        piston = add_capsule(world, {{start, -5.0}, {start, 5.0}, 0.0}, 0);
    }

    double place_at(double time) const { return start - speed * time; }

    void aim() {
        const double x = place_at(static_cast<double>(world.tick() + 1) / world.rate());
        world.edit_held_capsules() = {{piston, {x, -5.0}, {x, 5.0}, true}};
    }
};

// The invariant (v + u) L, as far as it is from its value at the first impact, as a share of that,
// until L is a tenth. v: the ball's speed before it meets the piston; u: the piston's; L: the free
// width there. After the impact the ball is at v + 2u; it goes L to the wall and comes back, the
// piston comes towards it, and they meet at L' = L (v + u) / (v + 3u), which is (v' + u) L' again.
double worst_error(SolverKind kind, double rate) {
    Piston scene(rate);
    World& world = scene.world;
    add_ball(world, {.position = {3.0, 0.0}, .velocity = {1.7, 0.0}, .radius = radius});
    Solver solver({.kind = kind});
    double constant = 0.0;
    double worst = 0.0;
    for (double width = 10.0; width > 1.0;) {
        scene.aim();
        solver.tick(world);
        for (const Contact& contact : solver.contacts()) {
            if (contact.b != number(scene.piston)) continue;
            width = scene.place_at(contact.time) - 2.0 * radius;
            const double speed = contact.approach - scene.speed;
            const double product = (speed + scene.speed) * width;
            if (constant == 0.0) constant = product;
            worst = std::max(worst, std::fabs(product / constant - 1.0));
            if (width < 1.0) break;
        }
        REQUIRE(world.time() < 100.0);
    }
    return worst;
}

// One ball whose impact with a piston comes exactly at the end of a tick: how fast it is then.
double speed_after_impact_at_end_of_tick(SolverKind kind) {
    World world = scenes::empty();
    world.edit_definition().rate = 1.0;
    const CapsuleId piston = add_capsule(world, {{8.0, -5.0}, {8.0, 5.0}, 0.0}, 0);
    add_ball(world, {.position = {3.0, 0.0}, .velocity = {3.0, 0.0}});
    Solver solver({.kind = kind});
    // They close the gap of 4 at a speed of 4, in one tick.
    for (int tick = 0; tick < 2; ++tick) {
        const double x = 7.0 - tick;
        world.edit_held_capsules() = {{piston, {x, -5.0}, {x, 5.0}, true}};
        solver.tick(world);
    }
    return -world.balls().velocity[0].x;
}

// By how much the energy of an elastic gas grows while a piston takes away half of its room.
double growth_of_compressed_gas(SolverKind kind, std::uint64_t seed) {
    World world = scenes::empty();
    world.edit_definition().rate = 60.0;
    const Box box{{0.0, 0.0}, {16.0, 4.0}};
    scenes::add_walls(world, box);
    const CapsuleId piston = add_capsule(world, {{16.0, -1.0}, {16.0, 5.0}, 0.0}, 0);
    std::uint64_t next = 0;
    const auto draw = [&](double low, double high) {
        return random_between(low, high, seed, RandomStream::level, 0, next++);
    };
    for (int i = 0; i < 48; ++i)
        add_ball(world, {.position = {0.6 + (i % 16) * 0.95, 0.7 + (i / 16) * 1.3},
                         .velocity = {draw(-8.0, 8.0), draw(-8.0, 8.0)},
                         .radius = 0.1});
    const double before = totals(world).kinetic_energy;
    Solver solver({.kind = kind});
    while (world.time() < 16.0) {
        const double x = 16.0 - 0.5 * static_cast<double>(world.tick() + 1) / world.rate();
        world.edit_held_capsules() = {{piston, {x, -1.0}, {x, 5.0}, true}};
        solver.tick(world);
    }
    return totals(world).kinetic_energy / before;
}

struct Mean {
    double value = 0.0;
    double error = 0.0;  // standard error
};
Mean growth_of_gases(SolverKind kind) {
    constexpr int count = 8;
    double sum = 0.0;
    double squares = 0.0;
    for (int seed = 0; seed < count; ++seed) {
        const double growth = growth_of_compressed_gas(kind, static_cast<std::uint64_t>(seed));
        sum += growth;
        squares += growth * growth;
    }
    const double mean = sum / count;
    return {mean, std::sqrt((squares / count - mean * mean) / (count - 1))};
}

}  // namespace

TEST_CASE("a driven edge gives its speed to every ball that it meets") {
    for (const double rate : {60.0, 240.0, 1000.0}) {
        CAPTURE(rate);
        CHECK(worst_error(SolverKind::event, rate) < 1e-9);
        CHECK(worst_error(SolverKind::contact, rate) < 1e-3);
        CHECK(worst_error(SolverKind::swept, rate) < 1e-9);
    }
}

TEST_CASE("a driven edge gives its speed to a ball that it meets exactly at the end of a tick") {
    for (const SolverKind kind : {SolverKind::swept, SolverKind::contact, SolverKind::event}) {
        CAPTURE(static_cast<int>(kind));
        CHECK(speed_after_impact_at_end_of_tick(kind) == doctest::Approx(5.0).epsilon(1e-12));
    }
}

TEST_CASE("a piston gives an elastic gas the same energy under every solver") {
    const Mean event = growth_of_gases(SolverKind::event);
    for (const SolverKind kind : {SolverKind::swept, SolverKind::contact}) {
        const Mean other = growth_of_gases(kind);
        CAPTURE(static_cast<int>(kind));
        CAPTURE(event.value);
        CAPTURE(other.value);
        MESSAGE(event.value, " +- ", event.error, ", ", other.value, " +- ", other.error);
        CHECK(std::fabs(other.value - event.value) < 3.0 * std::hypot(event.error, other.error));
    }
    // Half the room is twice the energy: that of a gas of discs in two dimensions.
    CHECK(event.value == doctest::Approx(2.0).epsilon(0.15));
}
