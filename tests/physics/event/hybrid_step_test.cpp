#include "physics/event/hybrid_step.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/open_air.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/fingerprint.h"

using namespace carom;
using open_air::add_floor;
using open_air::balls;

namespace {

double energy(const World& world) {
    const Totals t = totals(world);
    return t.kinetic_energy + t.potential_energy;
}

// Whether a ball becomes dense within `most` ticks.
bool makes_a_cluster(World world, int most) {
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < most; ++i) {
        solver.tick(world);
        if (!event_memory(world).clustered.empty()) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("event: a scene that is not too dense is never handed over to contact") {
    for (const double restitution : {0.3, 0.5, 0.9, 0.99}) {
        CAPTURE(restitution);
        // A ball that bounces until it rests.
        World bounce = open_air::make(restitution);
        add_floor(bounce);
        add_ball(bounce, {.position = {0.0, 3.0}, .velocity = {1.0, 0.0}});
        CHECK_FALSE(makes_a_cluster(bounce, 3000));
        // Balls that come to rest in the hollows between resting balls, and are hit there.
        World rack = open_air::make(restitution);
        add_floor(rack);
        for (int row = 0; row < 4; ++row)
            for (int i = 0; i < 4 - row; ++i)
                add_ball(rack, {.position = {i + 0.5 * row, 0.5 + 0.8660254037844386 * row},
                                .velocity = {}});
        add_capsule(rack, {{-0.5, 0.0}, {-0.5, 9.0}, 0.0}, 0);
        add_capsule(rack, {{3.5, 0.0}, {3.5, 9.0}, 0.0}, 0);
        CHECK_FALSE(makes_a_cluster(rack, 1000));
        if (restitution < 0.9) continue;
        // A cradle on a floor: as many out as in, again and again, until the walls have damped it.
        World cradle = open_air::make(restitution);
        add_floor(cradle);
        for (int i = 0; i < 8; ++i)
            add_ball(cradle, {.position = {1.0 * i, 0.5}, .velocity = {i < 2 ? 3.0 : 0.0, 0.0}});
        add_capsule(cradle, {{-5.0, 0.0}, {-5.0, 9.0}, 0.0}, 0);
        add_capsule(cradle, {{12.0, 0.0}, {12.0, 9.0}, 0.0}, 0);
        CHECK_FALSE(makes_a_cluster(cradle, 1000));
    }
    // A gas of elastic balls whose walls lose a little, and one that is twice as dense.
    for (const double shrink : {1.0, 0.775}) {
        World gas = scenes::gas(300, 7);
        gas.edit_definition().model.gravity = Vec2{0.0, -10.0};
        gas.edit_definition().model.inelastic = true;
        gas.edit_balls().restitution.assign(gas.balls().size(), 1.0);
        gas.edit_definition().materials[0].restitution = 0.95;
        for (Vec2& place : gas.edit_balls().position)
            place *= shrink;
        for (Capsule& wall : gas.edit_capsules().shape) {
            wall.start *= shrink;
            wall.end *= shrink;
        }
        for (double& radius : gas.edit_balls().radius)
            radius = std::min(radius, 0.99);
        CHECK_FALSE(makes_a_cluster(gas, 240));
    }
}

TEST_CASE("event: too many impacts in quick succession make a cluster") {
    World world = scenes::bucket(40, 0.5);
    CHECK(makes_a_cluster(world, 240));
    // Elastic balls of a bucket stay event-driven.
    CHECK_FALSE(makes_a_cluster(scenes::bucket(40, 1.0), 240));
    // The rule applies only under gravity.
    world.edit_definition().model.gravity.reset();
    for (Vec2& velocity : world.edit_balls().velocity)
        velocity = {0.0, -1.0};
    CHECK_FALSE(makes_a_cluster(world, 240));
}

TEST_CASE("event: a bucket of balls comes to rest as a cluster, without sinking into itself") {
    for (const double restitution : {0.0, 0.5, 0.8}) {
        CAPTURE(restitution);
        World world = scenes::bucket(120, restitution);
        Solver solver({.kind = SolverKind::event});
        const double start = energy(world);
        double before = start;
        double most = start;
        double most_gained = 0.0;
        double deepest = 0.0;
        std::size_t contacts = 0;
        int still = 0;  // `contact` freezes a ball that meets too much
        for (int i = 0; i < 1200; ++i) {
            still += solver.tick(world) == TickOutcome::stood_still;
            const double now = energy(world);
            most_gained = std::max(most_gained, now - before);
            before = now;
            most = std::max(most, now);
            deepest = std::max(deepest, deepest_overlap(world));
            contacts = std::max(contacts, solver.contacts().size());
        }
        const Totals end = totals(world);
        MESSAGE("restitution ", restitution, ": gained in a tick ", most_gained / start,
                ", deepest ", deepest, ", at rest ", deepest_overlap(world), ", KE ",
                end.kinetic_energy, ", most contacts ", contacts, ", all ",
                world.ledger().ball_ball_collisions);
        CHECK(still < 4);
        CHECK(world.balls().size() == 120);
        CHECK(event_memory(world).clustered.size() > 60);
        CHECK(most <= start * (1 + 1e-12));
        // Separating an overlap lifts balls a little: contact's promise.
        CHECK(most_gained < 2e-3 * start);
        CHECK(deepest < 0.1);
        CHECK(deepest_overlap(world) < 1e-3);
        CHECK(end.kinetic_energy < 1e-9);
        // Event-driven alone it has 4 million contacts within 5 s, up to 20,000 in a tick.
        CHECK(world.ledger().ball_ball_collisions < 200'000);
        for (const Vec2 place : world.balls().position)
            CHECK((place.x > 0.0 && place.x < 20.0 && place.y > 0.0));
        // A ball that falls on the heap is on an exact trajectory until it arrives.
        const BallId late = add_ball(world, {.position = {10.0, 40.0}, .velocity = {}});
        for (int i = 0; i < 120; ++i)
            solver.tick(world);
        CHECK(std::ranges::find(event_memory(world).clustered, late) ==
              event_memory(world).clustered.end());
        CHECK(std::abs(world.balls().position.back().y - 35.0) < 1e-12);
        CHECK(deepest_overlap(world) < 1e-3);
    }
}

// Clusters leave balls slightly inside the edges they lay on. Beside such an edge a ball entered
// the circle of its end before reaching the end, met nothing there, and did so again and again.
TEST_CASE("event: a ball slightly inside an edge slides off its end") {
    for (const double depth : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
        CAPTURE(depth);
        World world = open_air::make(0.3);
        add_capsule(world, {{0.0, 0.0}, {0.0, 20.0}, 0.0}, 0);
        add_ball(world, {.position = {0.5 - depth, 1.0}, .velocity = {0.0, -3.0}});
        add_ball(world, {.position = {-0.5 + depth, 19.0}, .velocity = {0.0, 8.0}});
        Solver solver({.kind = SolverKind::event});
        std::size_t impacts = 0;
        for (int i = 0; i < 40; ++i) {
            int asked = 0;
            REQUIRE(solver.tick(world, [&] { return ++asked < 1000; }) == TickOutcome::done);
            impacts += solver.contacts().size();
        }
        CHECK(impacts <= 2);
        CHECK(world.balls().position[0].y == doctest::Approx(1.0 - 3.0 * 0.4 - 5.0 * 0.16));
        CHECK(world.balls().position[1].y == doctest::Approx(19.0 + 8.0 * 0.4 - 5.0 * 0.16));
    }
}

TEST_CASE("event: a ball slightly inside an edge does not get through its end") {
    for (const double depth : {1e-3, 1e-4, 1e-5, 1e-7}) {
        for (std::uint32_t shot = 0; shot < 300; ++shot) {
            CAPTURE(depth);
            CAPTURE(shot);
            const auto share = [&](std::uint32_t of) { return std::fmod(0.618 * of * shot, 1.0); };
            const double circle = std::sqrt(2.0 * depth);
            const double speed = 0.3 + 2.7 * share(1);
            const double angle = 2.4 * share(2) - 1.2;
            World world = open_air::make(0.5);
            world.edit_definition().model.gravity =
                Vec2{10.0 * std::sin(angle), -10.0 * std::cos(angle)};
            add_capsule(world, {{0.0, 0.0}, {20.0, 0.0}, 0.0}, 0);
            add_ball(world,
                     {.position = {0.5 * circle * (1.0 + 0.05 * share(3)), 0.5 - 0.5 * depth},
                      .velocity = {-speed, share(5) * speed * circle}});
            Solver solver({.kind = SolverKind::event});
            for (int i = 0; i < 50; ++i) {
                int asked = 0;
                REQUIRE(solver.tick(world, [&] { return ++asked < 30; }) == TickOutcome::done);
                const Vec2 p = world.balls().position[0];
                REQUIRE((p.x >= 0.0 ? std::abs(p.y) : length(p)) >
                        0.5 * (1.0 - 2.0 * depth) - 1e-6);
            }
        }
    }
}

TEST_CASE(
    "event: a cluster whose floor vanishes falls, and its balls return to exact trajectories") {
    World world = open_air::make(0.3);
    const CapsuleId floor = add_capsule(world, {{-2.0, 0.0}, {2.0, 0.0}, 0.0}, 0);
    add_capsule(world, {{-2.0, 0.0}, {-2.0, 20.0}, 0.0}, 0);
    add_capsule(world, {{2.0, 0.0}, {2.0, 20.0}, 0.0}, 0);
    for (int i = 0; i < 30; ++i)
        add_ball(world, {.position = {-1.3 + 1.25 * (i % 3) + 0.03 * (i % 7), 0.6 + 1.1 * (i / 3)},
                         .velocity = {}});
    add_capsule(world, {{0.0, -30.0}, {0.0, -30.0}, 2.0}, 0);  // a peg divides the heap
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < 600; ++i)
        solver.tick(world);
    REQUIRE(event_memory(world).clustered.size() > 20);
    REQUIRE(totals(world).kinetic_energy < 1e-3);  // a ball may still glide under an arch
    remove_capsule(world, floor);
    for (int i = 0; i < 600; ++i)
        solver.tick(world);
    CHECK(event_memory(world).clustered.empty());
    CHECK(contact_memory(world).contacts.empty());
    const World then = world;
    std::size_t impacts = 0;
    for (int i = 0; i < 100; ++i) {
        solver.tick(world);
        impacts += solver.contacts().size();
    }
    CHECK(world.balls().size() == 30);
    REQUIRE(impacts == 0);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        // The column is some hundred long by now.
        const Vec2 fallen = then.balls().position[i] + then.balls().velocity[i] + Vec2{0.0, -5.0};
        CHECK(distance(world.balls().position[i], fallen) < 1e-11);
    }
}

TEST_CASE("event: removing a cluster leaves nothing behind") {
    World world = scenes::bucket(40, 0.5);
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < 400; ++i)
        solver.tick(world);
    REQUIRE(event_memory(world).clustered.size() > 20);
    while (world.balls().size() > 1)
        remove_ball(world, world.balls().id[0]);
    world.edit_balls().position[0].y = 30.0;
    solver.tick(world);
    CHECK(contact_memory(world).contacts.empty());
    World none = world;
    remove_ball(none, none.balls().id[0]);
    edit_event_memory(none).clustered = balls({3});
    solver.tick(none);
    CHECK(event_memory(none).clustered.empty());
    // Other solvers know nothing of clusters.
    edit_event_memory(world).clustered = balls({39});
    Solver swept({.kind = SolverKind::swept});
    swept.tick(world);
    CHECK(event_memory(world).clustered.empty());
}

TEST_CASE(
    "event: with a cluster, a copy continues with the same bits, and so does another solver") {
    for (const bool has_spin : {false, true}) {
        CAPTURE(has_spin);
        World world = scenes::bucket(120, 0.5);
        if (has_spin) {
            world.edit_definition().model.spin = 0.5;
            world.edit_balls().spin.assign(world.balls().size(), 0.0);
            world.edit_definition().kinds[0].friction =
                world.edit_definition().materials[0].friction = 0.3;
        }
        World copied = world;
        Solver solver({.kind = SolverKind::event});
        bool was_heaped = false;
        bool was_parted = false;
        for (int i = 0; i < 200; ++i) {
            solver.tick(world);
            copied = World(copied);
            Solver another({.kind = SolverKind::event});
            another.tick(copied);
            REQUIRE(fingerprint(copied) == fingerprint(world));
            was_heaped = was_heaped || !event_memory(world).clustered.empty();
            was_parted = was_parted || (!event_memory(world).clustered.empty() &&
                                        event_memory(world).clustered.size() < 110);
        }
        CHECK(was_heaped);
        CHECK(was_parted);
    }
}

TEST_CASE("event: a kinematic body moves once per tick, above a cluster and through it") {
    World world = scenes::bucket(120, 0.5);
    const CapsuleId blade = add_capsule(world, {{3.0, 20.0}, {3.0, 22.0}, 0.2}, 0);
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < 900; ++i)
        solver.tick(world);
    REQUIRE(event_memory(world).clustered.size() > 100);
    const auto go_to = [&](Vec2 low) {
        world.edit_held_capsules() = {{blade, low, low + Vec2{0.0, 2.0}}};
        solver.tick(world);
        return world.capsules().shape.back().start;
    };
    // Above the cluster it arrives exactly, tick after tick, and the cluster is undisturbed.
    for (int i = 1; i <= 60; ++i) {
        const Vec2 target{3.0, 20.0 - 0.1 * i};
        CHECK(distance(go_to(target), target) < 1e-12);
    }
    CHECK(totals(world).kinetic_energy < 1e-9);
    // Into it and sideways through it: it pushes balls along, and moves at most the full distance.
    double before = 14.0;
    for (int i = 1; i <= 120; ++i) {
        const double y = go_to({3.0, 14.0 - 0.1 * i}).y;
        CHECK(y <= before + 1e-12);
        before = y;
    }
    CHECK(before < 9.0);
    const World start = world;
    for (int i = 1; i <= 120; ++i)
        go_to({3.0 + 0.1 * i, before});
    CHECK(world.capsules().shape.back().start.x > 5.0);
    CHECK(world.balls().size() == 120);
    for (const Vec2 place : world.balls().position)
        CHECK((place.x > 0.0 && place.x < 20.0 && place.y > 0.0 && place.y < 60.0));
    // Released, it comes to rest again.
    world.edit_held_capsules().clear();
    for (int i = 0; i < 2000; ++i)
        solver.tick(world);
    CHECK(totals(world).kinetic_energy < 1e-9);
    CHECK(deepest_overlap(world) < 0.02 * 0.5);
    // Kinematic bodies belong to the world, so a copy continues alike.
    World one = start;
    World other = start;
    for (int i = 1; i <= 20; ++i) {
        const Vec2 low{3.0 + 0.1 * i, before};
        one.edit_held_capsules() =
            other.edit_held_capsules() = {{blade, low, low + Vec2{0.0, 2.0}}};
        solver.tick(one);
        Solver({.kind = SolverKind::event}).tick(other);
    }
    CHECK(fingerprint(one) == fingerprint(other));
}

TEST_CASE("event: a ball released above a cluster is free at once") {
    World world = scenes::bucket(120, 0.5);
    const BallId held = add_ball(world, {.position = {10.0, 50.0}, .velocity = {}});
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < 900; ++i) {
        world.edit_held_balls() = {{held, {10.0, 50.0}}};
        solver.tick(world);
    }
    REQUIRE(event_memory(world).clustered.size() > 100);
    world.edit_held_balls().clear();
    World copied = world;
    solver.tick(world);
    Solver({.kind = SolverKind::event}).tick(copied);
    CHECK(world.balls().position[*index_of(world, held)].y < 50.0);
    CHECK(fingerprint(copied) == fingerprint(world));
}

// Adds what needs many events on its own, far from the heap: a ball between two close walls.
void add_busy_ball(World& world) {
    add_capsule(world, {{100.0, 0.0}, {100.0, 9.0}, 0.0}, 0);
    add_capsule(world, {{101.0 + 1e-6, 0.0}, {101.0 + 1e-6, 9.0}, 0.0}, 0);
    const CapsuleId last = world.capsules().id.back();
    world.edit_definition().materials.push_back({.restitution = 1.0});
    for (std::size_t i = world.capsules().size() - 2; i < world.capsules().size(); ++i)
        world.edit_capsules().material[i] = 1;
    REQUIRE(index_of(world, last));
    add_ball(world, {.position = {100.5 + 5e-7, 5.0}, .velocity = {10.0, 0.0}});
}

TEST_CASE("event: a cancelled tick with a cluster leaves the world unchanged") {
    World world = scenes::bucket(120, 0.5);
    Solver solver({.kind = SolverKind::event});
    while (event_memory(world).clustered.empty())
        solver.tick(world);
    add_busy_ball(world);
    const World before = world;
    CHECK(solver.tick(world, [] { return false; }) == TickOutcome::cancelled);
    CHECK(fingerprint(world) == fingerprint(before));
    CHECK(event_memory(world).clustered == event_memory(before).clustered);
    CHECK(event_memory(world).trajectories.lines == event_memory(before).trajectories.lines);
    CHECK(contact_memory(world).contacts == contact_memory(before).contacts);
    World other = before;
    CHECK(solver.tick(world) == TickOutcome::done);
    Solver another({.kind = SolverKind::event});
    another.tick(other);
    CHECK(fingerprint(world) == fingerprint(other));
}

TEST_CASE("event: a cancelled tick without gravity keeps the cluster for when it comes back") {
    World world = scenes::bucket(120, 0.5);
    Solver solver({.kind = SolverKind::event});
    while (event_memory(world).clustered.empty())
        solver.tick(world);
    const auto gravity = world.model().gravity;
    add_busy_ball(world);
    const World before = world;
    world.edit_definition().model.gravity.reset();
    REQUIRE(solver.tick(world, [] { return false; }) == TickOutcome::cancelled);
    CHECK(event_memory(world).clustered == event_memory(before).clustered);
    world.edit_definition().model.gravity = gravity;
    World other = before;
    solver.tick(world);
    Solver({.kind = SolverKind::event}).tick(other);
    CHECK(fingerprint(world) == fingerprint(other));
}

TEST_CASE("event: an elastic gas above a cluster keeps its energy") {
    World world = scenes::bucket(60, 0.3);
    Solver solver({.kind = SolverKind::event});
    for (int i = 0; i < 1200; ++i)
        solver.tick(world);
    REQUIRE(event_memory(world).clustered.size() > 30);
    REQUIRE(totals(world).kinetic_energy < 1e-9);
    // A lid, on which elastic balls bounce between elastic walls, so that no cluster can damp them.
    world.edit_definition().materials.push_back({.restitution = 1.0});
    add_capsule(world, {{-1.0, 10.0}, {21.0, 10.0}, 0.5}, 1);
    for (std::size_t i = 0; i < world.capsules().size(); ++i)
        world.edit_capsules().material[i] = 1;
    const std::size_t first = world.balls().size();
    for (int i = 0; i < 30; ++i)
        add_ball(world, {.position = {1.0 + 3.0 * (i % 6), 12.0 + 2.0 * (i / 6)},
                         .velocity = {3.0 - 0.7 * (i % 9), 0.1 * i},
                         .restitution = 1.0});
    const auto energy_above = [&] {
        double sum = 0.0;
        for (std::size_t i = first; i < world.balls().size(); ++i)
            sum += 0.5 * length_squared(world.balls().velocity[i]) +
                   10.0 * world.balls().position[i].y;
        return sum;
    };
    const double before = energy_above();
    const std::uint64_t collisions = world.ledger().ball_ball_collisions;
    for (int i = 0; i < 600; ++i)
        solver.tick(world);
    CHECK(world.ledger().ball_ball_collisions - collisions > 100);
    CHECK(event_memory(world).clustered.size() > 30);
    CHECK(event_memory(world).clustered.back() < BallId{static_cast<std::uint32_t>(first)});
    MESSAGE("relative drift ", (energy_above() - before) / before);
    CHECK(energy_above() == doctest::Approx(before).epsilon(1e-12));
}

TEST_CASE(
    "event: fast balls that reach a cluster by an impact of the same tick do not pass into it") {
    // A row of balls in a cluster, and a shot that a heavier ball sends on towards it. The shot is
    // slow when the tick starts, and would be inside the row when it ends.
    World world = open_air::make(0.9);
    world.edit_definition().rate = 10.0;
    add_floor(world);
    for (int i = 0; i < 6; ++i)
        add_ball(world, {.position = {1.0 * i, 0.5}, .velocity = {}});
    const BallId slow = add_ball(world, {.position = {-7.0, 0.5}, .velocity = {}});
    add_ball(world, {.position = {-9.5, 0.5}, .velocity = {50.0, 0.0}, .mass = 100.0});
    edit_event_memory(world).clustered = balls({0, 1, 2, 3, 4, 5});
    Solver solver({.kind = SolverKind::event});
    solver.tick(world);
    // It has met the row.
    const auto contacts = solver.contacts();
    CHECK(std::ranges::any_of(contacts, [&](const Contact& contact) {
        return contact.kind == ContactKind::ball_ball && contact.a == 0 &&
               contact.b == number(slow);
    }));
    CHECK(deepest_overlap(world) < 0.26);
    CHECK(world.balls().position[6].x < world.balls().position[0].x);
}

TEST_CASE("event: a tick without a cluster keeps no contacts of an earlier one") {
    World world = open_air::make(0.5);
    add_ball(world, {.position = {0.0, 5.0}, .velocity = {}});
    edit_event_memory(world).contacts = {{.ball = BallId{0}, .other = 1, .impulse = 1.0}};
    Solver({.kind = SolverKind::event}).tick(world);
    CHECK(event_memory(world).contacts.empty());
}
