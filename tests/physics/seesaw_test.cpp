#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/solver.h"
#include "physics/support/cancelled.h"
#include "physics/support/dice.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/fingerprint.h"

// Seesaws: impulses both ways, against closed forms and conservation laws, under every solver that
// turns them.

using namespace carom;

namespace {

std::vector<SolverKind> turning_solvers() {
    std::vector<SolverKind> kinds;
    for (const SolverKind kind : solvers_available())
        if (supports(kind, Model{.hinged = true})) kinds.push_back(kind);
    return kinds;
}

// A plank from -2,0 to 2,0 with the hinge in the middle.
World plank(const Seesaw& seesaw = {.inertia = 2.0}) {
    World world = scenes::empty();
    world.edit_definition().rate = 240.0;
    Seesaw made = seesaw;
    made.home = {{-2.0, 0.0}, {2.0, 0.0}, 0.1};
    made.capsule = add_capsule(world, made.home, 0);
    add_seesaw(world, made);
    return world;
}

void pull_down(World& world) {
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
}

const Seesaw& seesaw_in(const World& world) {
    return world.seesaws().front();
}

// Without balls of other worlds: about the hinge, which is the origin.
double angular_momentum(const World& world) {
    return totals(world).angular_momentum;
}

void run_for(World& world, Solver& solver, double seconds) {
    const double end = world.time() + seconds - 0.5 * world.tick_length();
    while (world.time() < end)
        solver.tick(world);
}

double depth_in_seesaw(const World& world, std::size_t ball) {
    const Capsule& shape = world.capsules().shape[*index_of(world, seesaw_in(world).capsule)];
    return -separation(Disc{world.balls().position[ball], world.balls().radius[ball]}, shape);
}

// Balls of several sizes that fly at a plank which is free to turn, from all sides.
World shower(double restitution, bool spins, std::uint64_t seed) {
    World world = plank({.inertia = 3.0, .rate = 0.7});
    Definition& definition = world.edit_definition();
    if (spins) definition.model.spin = 0.5;
    definition.materials[0].restitution = restitution;
    definition.materials[0].friction = spins ? 0.3 : 0.0;
    definition.model.inelastic = restitution < 1.0;
    Dice dice{seed};
    for (int i = 0; i < 12; ++i) {
        const double direction = 2.0 * pi * (i + 0.5 * dice.next()) / 12.0;
        const Vec2 from{std::cos(direction), std::sin(direction)};
        const double radius = 0.1 + 0.2 * dice.next();
        add_ball(world, {.position = from * 5.0,
                         .velocity = from * -(2.0 + 2.0 * dice.next()) +
                                     perpendicular(from) * (dice.next() - 0.5),
                         .radius = radius,
                         .mass = 0.5 + dice.next(),
                         .restitution = restitution,
                         .spin = spins ? 4.0 * dice.next() - 2.0 : 0.0});
    }
    return world;
}

// Three balls above two planks with stops, in a box.
World two_planks(std::uint64_t seed) {
    World world = scenes::empty();
    Definition& definition = world.edit_definition();
    definition.rate = 240.0;
    definition.model.gravity = Vec2{0.0, -10.0};
    definition.model.spin = 0.5;
    definition.model.inelastic = true;
    definition.materials[0].restitution = 0.5;
    definition.materials[0].friction = definition.kinds[0].friction = 0.3;
    scenes::add_walls(world, {{-8.0, -6.0}, {8.0, 12.0}});
    Dice dice{seed};
    for (const Vec2 pivot : {Vec2{-4.0, 0.0}, Vec2{4.0, -3.0}}) {
        Seesaw seesaw{.home = {pivot - Vec2{3.0, 0.0}, pivot + Vec2{3.0, 0.0}, 0.15},
                      .pivot = pivot,
                      .inertia = dice.scaled(0.5, 20.0),
                      .least = -0.4,
                      .most = 0.4,
                      .stop_restitution = pivot.x > 0.0 ? 0.0 : 0.4,
                      .angle = dice.between(-0.3, 0.3),
                      .rate = dice.between(-1.0, 1.0)};
        seesaw.capsule = add_capsule(world, seesaw_shape(seesaw, seesaw.angle), 0);
        add_seesaw(world, seesaw);
    }
    for (const double x : {-6.0, -3.0, 5.0})
        add_ball(world, {.position = {x + dice.next(), 4.0},
                         .velocity = {dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)},
                         .radius = dice.between(0.2, 0.5),
                         .mass = dice.scaled(0.3, 3.0),
                         .restitution = 0.5});
    return world;
}

}  // namespace

TEST_CASE("seesaw: an impact passes what a hinged body takes") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = plank();
        add_ball(world, {.position = {1.5, 2.0}, .velocity = {0.4, -3.0}, .radius = 0.25});
        Solver solver({.kind = kind});
        const double energy = totals(world).energy();
        const double turn = angular_momentum(world);
        run_for(world, solver, 1.0);
        // It meets the plank at a height of 0.35, after 0.55 s.
        const double lever = 1.5 + 0.4 * 0.55;
        const double impulse = 2.0 * 3.0 / (1.0 + lever * lever / 2.0);
        CHECK(world.balls().velocity[0].x == doctest::Approx(0.4).epsilon(1e-13));
        CHECK(world.balls().velocity[0].y == doctest::Approx(impulse - 3.0).epsilon(1e-12));
        CHECK(seesaw_in(world).rate == doctest::Approx(-lever * impulse / 2.0).epsilon(1e-12));
        CHECK(seesaw_in(world).angle ==
              doctest::Approx(seesaw_in(world).rate * (1.0 - 0.55)).epsilon(1e-10));
        CHECK(totals(world).energy() == doctest::Approx(energy).epsilon(1e-13));
        CHECK(angular_momentum(world) == doctest::Approx(turn).epsilon(1e-13));
    }
}

TEST_CASE("seesaw: elastic impacts keep energy and angular momentum") {
    for (const SolverKind kind : turning_solvers())
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            CAPTURE(static_cast<int>(kind));
            CAPTURE(seed);
            World world = shower(1.0, false, seed);
            Solver solver({.kind = kind});
            const double energy = totals(world).energy();
            const double turn = angular_momentum(world);
            run_for(world, solver, 4.0);
            CHECK(world.ledger().ball_edge_collisions >= 5);
            CHECK(std::fabs(totals(world).energy() - energy) < 1e-12 * energy);
            CHECK(std::fabs(angular_momentum(world) - turn) < 1e-12 * energy);
        }
}

TEST_CASE("seesaw: losses and friction keep angular momentum, and give no energy") {
    for (const SolverKind kind : turning_solvers())
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            CAPTURE(static_cast<int>(kind));
            CAPTURE(seed);
            World world = shower(0.7, true, seed);
            Solver solver({.kind = kind});
            double energy = totals(world).energy();
            const double turn = angular_momentum(world);
            for (int tick = 0; tick < 960; ++tick) {
                solver.tick(world);
                const double now = totals(world).energy();
                CHECK(now <= energy * (1.0 + 1e-13));
                energy = now;
            }
            CHECK(world.ledger().ball_edge_collisions >= 5);
            CHECK(std::fabs(angular_momentum(world) - turn) < 1e-11 * energy);
        }
}

TEST_CASE("seesaw: a ball that falls on one arm throws another off the other") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = plank({.inertia = 1.5});
        add_ball(world,
                 {.position = {-1.5, 2.1}, .velocity = {0.0, -4.0}, .radius = 0.25, .mass = 1.0});
        // It touches the other arm.
        add_ball(world, {.position = {1.2, 0.35}, .radius = 0.25, .mass = 0.5});
        Solver solver({.kind = kind});
        run_for(world, solver, 0.5);
        // The impact at the left, then the plank at the right.
        const double left = 2.0 * 4.0 / (1.0 + 1.5 * 1.5 / 1.5);
        const double rate = 1.5 * left / 1.5;
        const double right = 2.0 * rate * 1.2 / (1.0 / 0.5 + 1.2 * 1.2 / 1.5);
        CHECK(world.balls().velocity[1].y == doctest::Approx(right / 0.5).epsilon(1e-9));
        CHECK(seesaw_in(world).rate == doctest::Approx(rate - 1.2 * right / 1.5).epsilon(1e-9));
    }
}

// The first ball turns the arm away from the second one, in the same substep of every solver.
TEST_CASE("seesaw: a ball hits an arm where another ball has just turned it to") {
    const auto after = [](SolverKind kind) {
        World world = plank({.inertia = 1.0});
        world.edit_definition().model.inelastic = true;  // else `swept` stands in for `contact`
        const double substep = world.tick_length() / 4.0;
        const double touch = 0.1 + 0.25;
        add_ball(world, {.position = {1.0, touch + 10.0 * 0.2 * substep},
                         .velocity = {0.0, -10.0},
                         .radius = 0.25,
                         .mass = 0.1});
        add_ball(world, {.position = {1.8, touch + 4.0 * 0.5 * substep},
                         .velocity = {0.0, -4.0},
                         .radius = 0.25,
                         .mass = 0.1});
        Solver solver({.kind = kind});
        solver.tick(world);
        REQUIRE(solver.contacts().size() == 2);
        return world;
    };
    const World truth = after(SolverKind::event);
    // At rest, the arm would throw the second ball up at 2.
    CHECK(truth.balls().velocity[1].y < -2.0);
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(name(kind));
        const World world = after(kind);
        CHECK(distance(world.balls().position[1], truth.balls().position[1]) < 1e-9);
        CHECK(distance(world.balls().velocity[1], truth.balls().velocity[1]) < 1e-6);
        CHECK(seesaw_in(world).angle == doctest::Approx(seesaw_in(truth).angle).epsilon(1e-6));
    }
}

TEST_CASE("seesaw: a cancelled tick leaves it as it was") {
    for (const SolverKind kind : {SolverKind::swept, SolverKind::event}) {
        CAPTURE(name(kind));
        World start = scenes::gas(1000, 6);
        start.edit_definition().rate = 0.5;
        Seesaw made{.inertia = 2.0, .rate = 3.0};
        made.pivot = {20.0, 20.0};
        made.home = {{15.0, 20.0}, {25.0, 20.0}, 0.1};
        made.capsule = add_capsule(start, made.home, 0);
        add_seesaw(start, made);
        World world = start;
        Solver solver({.kind = kind});
        cancel_at_each_poll(world, solver, [&] { REQUIRE(seesaw_in(world) == seesaw_in(start)); });
    }
}

TEST_CASE("seesaw: it bounces at its stops") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = plank(
            {.inertia = 2.0, .least = -0.25, .most = 0.5, .stop_restitution = 0.5, .rate = 1.0});
        Solver solver({.kind = kind});
        double least = 0.0;
        double most = 0.0;
        for (int tick = 0; tick < 240 * 3; ++tick) {
            solver.tick(world);
            least = std::min(least, seesaw_in(world).angle);
            most = std::max(most, seesaw_in(world).angle);
        }
        CHECK(most <= 0.5);
        CHECK(least >= -0.25);
        // To 0.5 in 0.5 s, to -0.25 in 1.5 s more, and on at a quarter.
        CHECK(seesaw_in(world).rate == 0.25);
        CHECK(seesaw_in(world).angle == doctest::Approx(-0.25 + 0.25 * 1.0).epsilon(1e-9));
    }
}

TEST_CASE("seesaw: time stands still for one that bounces too often in a tick, or turns too fast") {
    // 256 bounces between stops 0.5 apart are 128 rad: at 240 ticks a second, some 30,720 rad/s.
    const auto least_bounced = 128.0 * 240.0;
    for (const SolverKind kind : turning_solvers()) {
        for (const double rate : {0.9 * least_bounced, 1e9, 1e12, 1e18}) {
            CAPTURE(static_cast<int>(kind));
            CAPTURE(rate);
            World world = plank(
                {.inertia = 2.0, .least = 0.0, .most = 0.5, .stop_restitution = 1.0, .rate = rate});
            add_ball(world, {.position = {0.0, 2.5}, .velocity = {1.0, 0.0}, .radius = 0.25});
            Solver solver({.kind = kind});
            const bool stands = rate > least_bounced;
            for (int tick = 0; tick < 3; ++tick) {
                const TickOutcome outcome = solver.tick(world);
                CHECK(solver.standing_seesaws() == (stands ? 1 : 0));
                CHECK((outcome == TickOutcome::stood_still) == stands);
            }
            CHECK(std::fabs(seesaw_in(world).rate) == rate);
            CHECK(seesaw_in(world).bounces == 0);
            CHECK(world.balls().position[0].x == doctest::Approx(3.0 / 240.0));
        }
    }
}

TEST_CASE("seesaw: a ball that a hand presses against one at its stop ends its tick") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = plank(
            {.inertia = 2.0, .least = -0.2, .most = 0.2, .stop_restitution = 1.0, .rate = 0.5});
        add_ball(world, {.position = {1.0, 1.0}, .radius = 0.25});
        hold(world, {.id = world.balls().id[0], .target = {1.0, -1.0}});
        Solver solver({.kind = kind});
        for (int tick = 0; tick < 120; ++tick)
            solver.tick(world);
        CHECK(world.balls().position[0].y > 0.0);
        CHECK(depth_in_seesaw(world, 0) < 0.02 * 0.25);
        CHECK(std::fabs(seesaw_in(world).angle) <= 0.2);
    }
}

// Following a fast edge was one more push, which fed it.
TEST_CASE("seesaw: heavy balls on a light one gain no energy") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = scenes::empty();
        world.edit_definition().rate = 60.0;
        world.edit_definition().materials[0].restitution = 0.6;
        world.edit_definition().model.inelastic = true;
        world.edit_definition().model.gravity = Vec2{0.0, -50.0};
        Seesaw seesaw{.home = {{4.0, 12.0}, {16.0, 12.0}, 0.3},
                      .pivot = {10.0, 12.0},
                      .inertia = 0.12,
                      .least = 0.0,
                      .most = pi / 6.0,
                      .stop_restitution = 1.0,
                      .rate = -0.377};
        seesaw.capsule = add_capsule(world, seesaw.home, 0);
        add_seesaw(world, seesaw);
        const auto add = [&](Vec2 position, Vec2 velocity, double radius, double mass) {
            add_ball(world, {.position = position,
                             .velocity = velocity,
                             .radius = radius,
                             .mass = mass,
                             .restitution = 0.0});
        };
        add({16.0164, 13.3}, {-0.0137, -1.088}, 1.0, pi);
        add({12.2353, 13.3001}, {}, 1.0, pi);
        add({13.8829, 12.8754}, {2.008, -10.96}, 0.5, 1000.0);
        add({10.2449, 12.875}, {-5.96, -13.418}, 0.5, 1000.0);
        add({13.5079, 9.53489}, {-30.1, 92.51}, 0.5, 1000.0);
        Solver solver({.kind = kind});
        const double before = totals(world).energy();
        for (int tick = 0; tick < 60; ++tick) {
            solver.tick(world);
            const double rate = seesaw_in(world).rate;
            CHECK(totals(world).energy() + 0.5 * 0.12 * rate * rate <= 1.01 * before);
        }
    }
}

TEST_CASE("seesaw: a stop carries the load") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = plank({.inertia = 2.0, .least = 0.0, .most = 0.5});
        add_ball(world, {.position = {1.5, 1.35}, .velocity = {0.0, -1.0}, .radius = 0.25});
        Solver solver({.kind = kind});
        run_for(world, solver, 2.0);
        // As off a fixed edge.
        CHECK(world.balls().velocity[0].y == 1.0);
        CHECK(seesaw_in(world).rate == 0.0);
        CHECK(seesaw_in(world).angle == 0.0);
    }
}

TEST_CASE("seesaw: a ball at rest tips it") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = plank({.inertia = 2.0, .least = -0.6, .most = 0.6});
        world.edit_definition().materials[0].restitution = 0.5;
        world.edit_definition().model.inelastic = true;
        pull_down(world);
        add_ball(world, {.position = {1.0, 0.35}, .radius = 0.25, .restitution = 0.5});
        Solver solver({.kind = kind});
        const double energy = totals(world).energy();
        run_for(world, solver, 0.3);
        const double acceleration = 10.0 / (2.0 + 1.0);
        CHECK(seesaw_in(world).angle == doctest::Approx(-0.5 * acceleration * 0.09).epsilon(0.03));
        CHECK(seesaw_in(world).rate == doctest::Approx(-acceleration * 0.3).epsilon(0.05));
        CHECK(totals(world).energy() <= energy + 1e-9);
        CHECK(depth_in_seesaw(world, 0) < 1e-3);
        // Down to the stop, and off the end.
        run_for(world, solver, 0.5);
        CHECK(seesaw_in(world).angle < -0.5);
        run_for(world, solver, 3.0);
        CHECK(world.balls().position[0].y < -3.0);
    }
}

TEST_CASE("seesaw: two equal balls at equal distances balance") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = plank({.inertia = 2.0, .least = -0.6, .most = 0.6});
        world.edit_definition().materials[0].restitution = 0.5;
        world.edit_definition().model.inelastic = true;
        pull_down(world);
        for (const double side : {-1.0, 1.0})
            add_ball(world, {.position = {side * 1.25, 0.35}, .radius = 0.25, .restitution = 0.5});
        Solver solver({.kind = kind});
        run_for(world, solver, 2.0);
        // The balance is unstable, and `swept` presses the balls on the plank one after the other.
        const double most = kind == SolverKind::swept ? 3e-3 : 1e-6;
        CHECK(std::fabs(seesaw_in(world).angle) < most);
        for (const std::size_t ball : {0u, 1u}) {
            CHECK(std::fabs(world.balls().position[ball].y - 0.35) < 2e-3 + 2.0 * most);
            CHECK(std::fabs(std::fabs(world.balls().position[ball].x) - 1.25) < 1e-3 + most);
        }
    }
}

TEST_CASE("seesaw: balls that roll, bounce and lie on two of them") {
    for (const SolverKind kind : turning_solvers())
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            CAPTURE(static_cast<int>(kind));
            CAPTURE(seed);
            World world = two_planks(seed);
            Solver solver({.kind = kind});
            const double whole = totals(world).energy();
            double least = whole;
            for (int tick = 0; tick < 240 * 4; ++tick) {
                solver.tick(world);
                const double energy = totals(world).energy();
                // What `swept`, `contact` and hybrid steps may give (their READMEs, "Energy").
                CHECK(energy <= least + 2e-3 * std::fabs(whole));
                least = std::min(least, energy);
                for (const Seesaw& seesaw : world.seesaws()) {
                    CHECK(std::fabs(seesaw.angle) <= 0.4);
                    const Capsule& shape = world.capsules().shape[*index_of(world, seesaw.capsule)];
                    CHECK(shape == seesaw_shape(seesaw, seesaw.angle));
                    for (std::size_t i = 0; i < world.balls().size(); ++i) {
                        const double radius = world.balls().radius[i];
                        const double depth =
                            -separation(Disc{world.balls().position[i], radius}, shape);
                        CHECK(depth < (kind == SolverKind::swept ? 1e-9 : 0.1) * radius);
                    }
                }
            }
        }
}

// Regression: the plank took on the ball's speed, so it bounced at its stop in every substep of
// `contact`, and let the ball sink in, by a tenth of its radius. What opened that threw the ball
// off.
TEST_CASE("seesaw: one that a ball presses on its stop carries the ball, and throws nothing off") {
    for (const SolverKind kind : {SolverKind::contact, SolverKind::event})
        for (const std::uint64_t seed : {21, 83, 120}) {
            CAPTURE(static_cast<int>(kind));
            CAPTURE(seed);
            World world = two_planks(seed);
            Solver solver({.kind = kind});
            const double whole = totals(world).energy();
            double least = whole;
            double rise = 0.0;
            for (int tick = 0; tick < 320; ++tick) {
                solver.tick(world);
                rise = std::max(rise, totals(world).energy() - least);
                least = std::min(least, totals(world).energy());
            }
            CHECK(rise < 2e-3 * std::fabs(whole));
        }
}

TEST_CASE("seesaw: a copy, and a new solver, go on with the same bits") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = shower(0.8, true, 7);
        pull_down(world);
        Solver solver({.kind = kind});
        run_for(world, solver, 0.5);
        World copy = world;
        run_for(world, solver, 0.5);
        Solver other({.kind = kind});
        run_for(copy, other, 0.5);
        CHECK(fingerprint(copy) == fingerprint(world));
        CHECK(copy.seesaws() == world.seesaws());
        World turned = world;
        turned.edit_seesaws().front().rate += 1.0;
        CHECK(fingerprint(turned) != fingerprint(world));
    }
}

TEST_CASE("seesaw: a cancelled tick leaves it as it was") {
    for (const SolverKind kind : turning_solvers()) {
        CAPTURE(static_cast<int>(kind));
        World world = shower(1.0, false, 3);
        Solver solver({.kind = kind});
        run_for(world, solver, 1.5);
        const World before = world;
        if (solver.tick(world, [] { return false; }) != TickOutcome::cancelled) continue;
        CHECK(world.seesaws() == before.seesaws());
        CHECK(world.capsules().shape == before.capsules().shape);
        CHECK(world.held_capsules().empty());
        CHECK(fingerprint(world) == fingerprint(before));
    }
}

TEST_CASE("seesaw: solvers that cannot turn it are not picked") {
    World world = plank();
    add_ball(world, {.position = {1.5, 2.0}});
    CHECK(supports(pick_solver(world).settings.kind, world.model()));
    CHECK_FALSE(supports(SolverKind::discrete, world.model()));
    CHECK_FALSE(supports(SolverKind::substep, world.model()));
}

TEST_CASE("seesaw: a bar about its middle and about its end") {
    const Capsule bar{{1.0, 1.0}, {4.0, 5.0}, 0.1};
    CHECK(bar_inertia(bar, {2.5, 3.0}) == doctest::Approx(25.0 / 12.0));
    CHECK(bar_inertia(bar, {1.0, 1.0}) == doctest::Approx(25.0 / 3.0));
}
