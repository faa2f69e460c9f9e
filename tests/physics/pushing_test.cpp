#include <doctest/doctest.h>

#include <algorithm>

#include "physics/solver.h"
#include "physics/support/pushes.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "support/sanitizers.h"

// Hands that push rows, heaps and buckets together: nothing passes through anything, balls are not
// thrown, no energy comes from nowhere, and a hand that cannot advance stands still until it can.
// docs/accuracy.md has what 1,000 of these pushes give.

using namespace carom;
using carom::test::has_sanitizers;

namespace {

// What a solver promises of a push.
struct Bounds {
    SolverKind kind;
    double gain;          // energy beyond the work of the hands, as a share of the total
    double gain_pressed;  // the same where gravity presses balls together
    double overlap;       // radii more than without a push
    double overlap_pressed;
};
constexpr Bounds of_swept{SolverKind::swept, 1e-9, 1e-3, 1e-9, 1e-9};
constexpr Bounds of_event{SolverKind::event, 1e-9, 1e-9, 1e-3, 0.05};
constexpr Bounds of_contact{SolverKind::contact, 1e-2, 1e-2, 0.02 + 1e-9, 0.02 + 1e-9};

void check_push(const Bounds& bounds, int number) {
    const bool with_cloth = bounds.kind != SolverKind::contact && number % 5 == 0;
    const pushes::Push push = pushes::random_push(static_cast<std::uint64_t>(number), with_cloth);
    CAPTURE(number);
    CAPTURE(push.name);
    const pushes::Result result = pushes::run(push, bounds.kind, true);
    const bool is_pressed = push.world.model().gravity.has_value();
    CHECK(result.passed == 0);
    CHECK(result.speed < 3.0);
    CHECK(result.gain < (is_pressed ? bounds.gain_pressed : bounds.gain));
    CHECK(result.overlap - result.without < (is_pressed ? bounds.overlap_pressed : bounds.overlap));
}

void check_pushes(const Bounds& bounds, int first, int last) {
    for (int number = first; number < last; ++number)
        check_push(bounds, number);
}

// Twelve balls in a row on a floor between walls. A hand moves the right wall from 40 to 6.
struct Row {
    World world = scenes::empty();
    CapsuleId wall{};

    Row() {
        world.edit_definition().rate = 120.0;
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().kinds = {{.radius = 1.0, .mass = 3.0, .restitution = 0.5}};
        world.edit_definition().materials = {{.restitution = 0.5}};
        world.edit_definition().model.inelastic = true;
        add_capsule(world, {{0.0, 0.0}, {42.0, 0.0}, 0.0}, 0);
        add_capsule(world, {{0.0, 0.0}, {0.0, 40.0}, 0.0}, 0);
        wall = add_capsule(world, {{40.0, 0.6}, {40.0, 40.0}, 0.5}, 0);
        for (int i = 0; i < 12; ++i)
            add_ball(world, {.position = {2.0 + 3.0 * i, 1.0}, .velocity = {0.03 * (i % 3), 0.05}});
    }

    double wall_place() const { return world.capsules().shape[2].start.x; }
    void hold_wall_at(double x) { world.edit_held_capsules() = {{wall, {x, 0.6}, {x, 40.0}}}; }
};

}  // namespace

// Regression: the wall went through the row under `event` and `contact`, and balls left at up to
// 6,800. A hand that was held back went to its target within the next tick, however far that was.
TEST_CASE("a wall that closes on a row of balls stops at it, and goes on once it can") {
    for (const SolverKind kind : {SolverKind::swept, SolverKind::contact, SolverKind::event}) {
        CAPTURE(static_cast<int>(kind));
        for (const double speed : {kind == SolverKind::event ? 30.0 : 10.0}) {
            CAPTURE(speed);
            Row row;
            World& world = row.world;
            Solver solver({.kind = kind});
            double fastest = 0.0;
            const auto go_on = [&](double target) {
                row.hold_wall_at(target);
                solver.tick(world);
                for (const Vec2 velocity : world.balls().velocity)
                    fastest = std::max(fastest, length(velocity));
            };
            for (double x = 40.0; x > 6.0;)
                go_on(x = std::max(6.0, x - speed / world.rate()));
            // The hand has been slower than its target: it gets a second to come as far as it can.
            for (int tick = 0; tick < 120; ++tick)
                go_on(6.0);
            CHECK(fastest < 3.0 * speed);
            // The row is 24 wide, and the wall has a radius of 0.5.
            CHECK(row.wall_place() > 24.0);
            CHECK(row.wall_place() < 26.0);
            for (const Vec2 place : world.balls().position)
                CHECK(place.x < row.wall_place());
            // Half of the balls are taken away from under its target: now it can.
            while (world.balls().size() > 2)
                remove_ball(world, world.balls().id.back());
            for (int tick = 0; tick < 2400 && row.wall_place() > 6.0; ++tick)
                go_on(6.0);
            CHECK(row.wall_place() == doctest::Approx(6.0).epsilon(1e-9));
            CHECK(fastest < 3.0 * speed);
        }
    }
}

// Regression: `event` did not look for impacts of kinematic edges with balls at rest.
TEST_CASE("event: a hand pushes a ball that lies at rest") {
    Row row;
    World& world = row.world;
    while (world.balls().size() > 1)
        remove_ball(world, world.balls().id.back());
    Solver solver({.kind = SolverKind::event});
    for (int tick = 0; tick < 600; ++tick)
        solver.tick(world);
    REQUIRE(world.balls().velocity[0].y == 0.0);
    for (double x = 40.0; x > 3.0;) {
        row.hold_wall_at(x -= 10.0 / world.rate());
        solver.tick(world);
    }
    CHECK(world.balls().position[0].x < row.wall_place());
    CHECK(deepest_overlap(world) < 1e-4);
}

// Regression: `event` gave every ball that met a held one 5 % of its approach, even an elastic ball
// that met one at rest.
TEST_CASE("a ball leaves a held ball as it would leave a fixed one, or a little faster than it") {
    for (const SolverKind kind : {SolverKind::swept, SolverKind::event}) {
        CAPTURE(static_cast<int>(kind));
        for (const double restitution : {1.0, 0.5, 0.0}) {
            CAPTURE(restitution);
            for (const double pace : {0.0, 2.0}) {
                CAPTURE(pace);
                World world = scenes::empty();
                world.edit_definition().kinds[0].restitution = restitution;
                world.edit_definition().model.inelastic = restitution < 1.0;
                const BallId hand = add_ball(world, {.position = {0.0, 0.0}});
                add_ball(world, {.position = {8.0, 0.0}, .velocity = {-3.0, 0.0}});
                Solver solver({.kind = kind});
                for (int tick = 1; tick <= 360; ++tick) {
                    world.edit_held_balls() = {{hand, {pace * tick / world.rate(), 0.0}}};
                    solver.tick(world);
                }
                const double expected = std::max(pace * 1.05 + 0.05 * 3.0, restitution * 3.0);
                CHECK(world.balls().velocity[1].x ==
                      doctest::Approx(pace > 0.0 ? expected : restitution * 3.0).epsilon(1e-6));
            }
        }
    }
}

TEST_CASE("a hand lifts a pile") {
    for (const SolverKind kind : {SolverKind::contact, SolverKind::event}) {
        CAPTURE(static_cast<int>(kind));
        World world = scenes::empty();
        world.edit_definition().rate = 120.0;
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().kinds = {{.radius = 1.0, .mass = 3.0, .restitution = 0.5}};
        world.edit_definition().materials = {{.restitution = 0.5}};
        world.edit_definition().model.inelastic = true;
        const CapsuleId plate = add_capsule(world, {{0.01, 0.0}, {8.4, 0.0}, 0.0}, 0);
        add_capsule(world, {{0.0, 0.0}, {0.0, 40.0}, 0.0}, 0);
        add_capsule(world, {{8.41, 0.0}, {8.41, 40.0}, 0.0}, 0);
        for (int i = 0; i < 12; ++i)
            add_ball(world,
                     {.position = {1.05 + 2.1 * (i % 4) + 0.01 * (i / 4), 1.0 + 2 * (i / 4)}});
        Solver solver({.kind = kind});
        double y = 0.0;
        for (int tick = 0; tick < 240; ++tick) {
            y += 0.5 / world.rate();
            world.edit_held_capsules() = {{plate, {0.01, y}, {8.4, y}}};
            solver.tick(world);
        }
        CHECK(world.capsules().shape[0].start.y == doctest::Approx(1.0).epsilon(0.01));
        for (const Vec2 place : world.balls().position)
            CHECK(place.y > 1.9);
    }
}

TEST_CASE("swept: random pushes") {
    check_pushes(of_swept, 0, has_sanitizers ? 2 : 16);
}
TEST_CASE("event: random pushes") {
    check_pushes(of_event, 0, has_sanitizers ? 2 : 16);
}
// Regression: `contact` reported a constraint once, when it began to press.
TEST_CASE("contact: what it reports of a push is what the ball has gained") {
    Row row;
    World& world = row.world;
    world.edit_definition().model.gravity.reset();
    while (world.balls().size() > 1)
        remove_ball(world, world.balls().id.back());
    world.edit_balls().position[0] = {38.4, 5.0};
    world.edit_balls().velocity[0] = {};
    Solver solver({.kind = SolverKind::contact});
    double impulse = 0.0;
    for (double x = 40.0; x > 10.0;) {
        row.hold_wall_at(x -= 10.0 / world.rate());
        solver.tick(world);
        for (const auto& contacts : {solver.contacts(), solver.pressing()})
            for (const Contact& contact : contacts)
                impulse += contact.impulse * contact.normal.x;
        const double gained = 3.0 * world.balls().velocity[0].x;
        CHECK(impulse == doctest::Approx(gained).epsilon(1e-9));
    }
    CHECK(impulse < -29.0);
}

// Regression: `contact` did not report what it gave to a ball that stays pressed.
TEST_CASE("contact: the hand under a ball that it lifts reports its weight") {
    Row row;
    World& world = row.world;
    while (world.balls().size() > 1)
        remove_ball(world, world.balls().id.back());
    const CapsuleId plate = add_capsule(world, {{0.5, 0.5}, {4.0, 0.5}, 0.0}, 0);
    world.edit_balls().position[0] = {2.0, 1.5};
    world.edit_balls().velocity[0] = {};
    Solver solver({.kind = SolverKind::contact});
    double impulse = 0.0;
    double y = 0.5;
    for (int tick = 0; tick < 240; ++tick) {
        y += 0.5 / world.rate();
        world.edit_held_capsules() = {{plate, {0.5, y}, {4.0, y}}};
        solver.tick(world);
        for (const auto& contacts : {solver.contacts(), solver.pressing()})
            for (const Contact& contact : contacts)
                impulse += contact.impulse * contact.normal.y;
    }
    // Two seconds of its weight, and the momentum of the lift.
    CHECK(impulse == doctest::Approx(3.0 * 10.0 * 2.0 + 3.0 * 0.5).epsilon(1e-3));
}

TEST_CASE("contact: random pushes") {
    check_pushes(of_contact, 0, has_sanitizers ? 10 : 40);
}

// Regression: balls that a hand had thrown into a jam or a heap squashed it by up to 0.41 radii,
// while the hand stood still for their sake.
TEST_CASE("contact: balls that a hand has thrown do not squash others once it stands still") {
    for (const int number : {501, 116, 971, 593, 495, 615, 566})
        check_push(of_contact, number);
}

TEST_SUITE("long") {
    TEST_CASE("swept: 1,000 random pushes") {
        check_pushes(of_swept, 0, 1000);
    }
    TEST_CASE("event: 1,000 random pushes") {
        check_pushes(of_event, 0, 1000);
    }
    TEST_CASE("contact: 4,000 random pushes") {
        check_pushes(of_contact, 0, 4000);
    }
}
