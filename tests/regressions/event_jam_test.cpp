#include <cmath>
#include <ctime>

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"

// Balls that gravity presses against an obstacle. The solver `event` did not recognise that they
// rest there, and found thousands of impacts a second with the obstacle, each slightly deeper.

using namespace carom;

namespace {

World under_gravity(double restitution) {
    World world = scenes::empty();
    world.edit_definition().rate = 100.0;
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.inelastic = restitution < 1.0;
    world.edit_definition().kinds[0].restitution =
        world.edit_definition().materials[0].restitution = restitution;
    return world;
}

struct Run {
    std::size_t contacts = 0;
    int asked = 0;  // every 4096 events, and sooner if impacts take many iterations
};

Run run(World& world, int ticks) {
    Solver solver({.kind = SolverKind::event});
    Run done;
    for (int tick = 0; tick < ticks; ++tick) {
        solver.tick(world, [&] { return ++done.asked < 1000; });
        done.contacts += solver.contacts().size();
    }
    return done;
}

}  // namespace

TEST_CASE("event: a ball rests where a slope meets a wall or an overhang") {
    for (const double restitution : {0.0, 0.5, 1.0})
        for (const double slope : {0.2, 0.5, 1.2})
            for (const double over : {0.3, 0.6, 1.0}) {
                CAPTURE(restitution);
                CAPTURE(slope);
                CAPTURE(over);
                // The other edge leans over the slope, or is upright.
                const double other = slope + (std::acos(-1.0) / 2.0 - slope) * over;
                const double half = (other - slope) / 2.0;
                const Vec2 down{std::cos(slope), std::sin(slope)};
                const Vec2 place =
                    Vec2{std::cos(slope + half), std::sin(slope + half)} * (0.5 / std::sin(half));
                for (const double above : {0.0, 0.5}) {
                    if (above > 0.0 && restitution == 1.0) continue;  // bounces on
                    CAPTURE(above);
                    World world = under_gravity(restitution);
                    add_capsule(world, {{0.0, 0.0}, down * 40.0, 0.0}, 0);
                    add_capsule(
                        world, {{0.0, 0.0}, Vec2{std::cos(other), std::sin(other)} * 40.0, 0.0}, 0);
                    add_ball(world, {.position = place + down * above, .radius = 0.5});
                    CHECK(run(world, 300).contacts < 400);
                    CHECK(event_memory(world).trajectories.lines[0].motion == Motion::resting);
                    CHECK(length(world.balls().position[0] - place) < 1e-8);
                }
            }
}

TEST_CASE("event: a ball that turns round a peg comes to rest against the end of a wall") {
    for (const double restitution : {0.0, 0.5})
        for (const double angle : {0.05, 0.3})
            for (const double share : {0.5, 1.0}) {
                CAPTURE(restitution);
                CAPTURE(angle);
                CAPTURE(share);
                const auto on_peg = [](double at) {
                    return Vec2{0.7 * std::sin(at), 0.7 * std::cos(at)};
                };
                World world = under_gravity(restitution);
                add_capsule(world, {{0.0, 0.0}, {0.0, 0.0}, 0.2}, 0);
                const Vec2 end = on_peg(angle) + Vec2{0.5, 0.0};
                add_capsule(world, {end, end + Vec2{3.0, 0.0}, 0.0}, 0);
                add_ball(world, {.position = on_peg(angle * share), .radius = 0.5});
                CHECK(run(world, 1000).contacts < 200);
                CHECK(event_memory(world).trajectories.lines[0].motion == Motion::resting);
                CHECK(length(world.balls().position[0] - end) - 0.5 > -1e-8);
                CHECK(length(world.balls().position[0]) - 0.7 > -1e-8);
            }
}

// Each iteration took a share of their speeds away, down to the smallest denormal.
TEST_CASE("event: elastic balls placed inside edges and each other come to rest") {
    World world = under_gravity(1.0);
    add_capsule(world, {{0.0, 0.0}, {12.0, 0.0}, 0.1}, 0);
    add_capsule(world, {{0.0, 12.0}, {0.0, 0.0}, 0.1}, 0);
    add_capsule(world, {{0.8, 0.4}, {0.95, 0.95}, 0.05}, 0);
    add_capsule(world, {{0.6, 1.53}, {0.25, 1.3}, 0.0}, 0);
    add_ball(world, {.position = {0.83, 0.6}, .radius = 0.5});
    add_ball(world, {.position = {0.42, 0.9}, .radius = 0.5});
    const Run done = run(world, 20);
    CHECK(done.asked < 5);
    CHECK(done.contacts < 20000);
}

// The ball was put to rest on the floor that it would leave for the other at once. It bounced back
// within the same instant until its speed was used up.
TEST_CASE("event: a ball that passes from one floor to another slides on the higher one") {
    for (const bool is_flat_first : {false, true}) {
        CAPTURE(is_flat_first);
        World world = under_gravity(1.0);
        world.edit_definition().model.gravity = Vec2{-2.0, -10.0};
        const Capsule flat{{-10.0, 0.0}, {10.0, 0.0}, 0.0};
        const Capsule falling{{-10.0, 0.06}, {10.0, -0.06}, 0.0};
        add_capsule(world, is_flat_first ? flat : falling, 0);
        add_capsule(world, is_flat_first ? falling : flat, 0);
        const double half = std::atan2(0.006, 1.0) / 2.0;
        add_ball(world, {.position = Vec2{std::tan(half), 1.0} * 0.5,
                         .velocity = {0.0035, 0.0},
                         .radius = 0.5});
        Solver solver({.kind = SolverKind::event});
        int asked = 0;
        REQUIRE(solver.tick(world, [&] { return ++asked < 5; }) == TickOutcome::done);
        CHECK(solver.contacts().size() < 2000);
        CHECK(world.balls().position[0].y > 0.5 - 1e-6);
    }
}

// The solver released the ball from the floor, but the ball was too slow to reach the obstacle. It
// met the floor again and again, slightly deeper each time, until the tick was given up.
TEST_CASE("event: a ball that moves slowly along a floor meets the wall or ball beside it") {
    for (const bool is_wall : {false, true})
        for (const double drag : {0.0, 0.3})
            for (const double restitution : {0.0, 0.3})
                for (const double speed : {1e-8, 1e-6, 5e-5}) {
                    CAPTURE(is_wall);
                    CAPTURE(drag);
                    CAPTURE(restitution);
                    CAPTURE(speed);
                    World world = under_gravity(restitution);
                    if (drag > 0.0) world.edit_definition().model.drag = drag;
                    add_capsule(world, {{-40.0, 0.0}, {40.0, 0.0}, 0.0}, 0);
                    if (is_wall)
                        add_capsule(world, {{-0.5, -3.0}, {-0.5, 10.0}, 0.0}, 0);
                    else
                        add_ball(world, {.position = {-1.0, 0.5}, .radius = 0.5});
                    add_ball(world,
                             {.position = {0.0, 0.5}, .velocity = {-speed, 0.0}, .radius = 0.5});
                    CHECK(run(world, 50).contacts < 10);
                    CHECK(std::abs(world.balls().position.back().y - 0.5) < 1e-9);
                    if (!is_wall) continue;
                    const double left = restitution * speed * std::exp(-drag * 0.5);
                    CHECK(std::abs(world.balls().velocity[0].x - left) < 1e-3 * speed);
                }
}

// At the end that two edges share, the search for the other edge's end took a million iterations.
TEST_CASE("event: a ball that moves slowly over the ridge of two edges costs next to nothing") {
    World world = under_gravity(0.5);
    add_capsule(world, {{0.0, 0.0}, {40.0, 0.0}, 0.0}, 0);
    add_capsule(world, {{0.0, 0.0}, {-40.0, -0.4}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 0.5}, .velocity = {-1e-4, 0.0}, .radius = 0.5});
    const double before = static_cast<double>(std::clock());
    CHECK(run(world, 300).contacts < 100);
    CHECK((static_cast<double>(std::clock()) - before) / CLOCKS_PER_SEC < 0.5);
    CHECK(world.balls().velocity[0].x < -0.01);
}

namespace {

// Whether a tick ends in which the ball at `from` is dragged to `to`.
bool ends_with_hand(World world, double spin, Vec2 from, Vec2 to, Vec2 velocity = {}) {
    const BallId held = add_ball(world, {.position = from, .velocity = velocity, .radius = 0.5});
    world.edit_balls().spin.back() = spin;
    world.edit_held_balls() = {{held, to}};
    int asked = 0;
    Solver solver({.kind = SolverKind::event});
    return solver.tick(world, [&] { return ++asked < 20; }) == TickOutcome::done;
}

}  // namespace

// A ball and its jammed neighbours were frozen together. The collapse guard froze the ball at the
// same instant, and its neighbours met it again without end.
TEST_CASE("event: a ball frozen by the collapse guard stops a jammed ball that meets it") {
    SUBCASE("in a heap driven by a turning edge") {
        World world = under_gravity(0.916212115243346);
        world.edit_definition().rate = 112.45867869668238;
        world.edit_definition().model.gravity = Vec2{-1.7595310857244439, -10};
        world.edit_definition().model.spin = 0.5;
        world.edit_definition().model.wrap = Box{{0, 0}, {12, 12}};
        world.edit_definition().kinds[0].friction = world.edit_definition().materials[0].friction =
            0.46443842557153525;
        add_capsule(world, {{0, 0}, {12, 0}, 0.1}, 0);
        const Vec2 peg{2.1293809267449784, 1.5668510420726591};
        add_capsule(world, {peg, peg, 0.1}, 0);
        const Vec2 point{8.7651744180296625, 1.1597840377354309};
        add_capsule(world, {point, point, 0.0}, 0);
        add_ball(world, {.position = {8.8, 0.4}, .radius = 0.3, .mass = 2.0});
        add_ball(world, {.position = {9.49, 0.86}, .radius = 0.5});
        add_ball(world, {.position = {10.6, 0.7}, .radius = 0.5});
        add_ball(world, {.position = {0.27, 1.34}, .radius = 0.5});
        world.edit_balls().spin = {20, -48, 35, 15};
        CHECK(
            ends_with_hand(world, 52.0, {1.934, 2.203}, {9.0693224385413487, 9.2722200228548353}));
    }
    SUBCASE("in a row pushed into a corner") {
        World world = under_gravity(1.0);
        world.edit_definition().rate = 206.57188127763254;
        world.edit_definition().model.gravity = Vec2{-2.2018241751008993, -10};
        world.edit_definition().model.spin = 0.5;
        world.edit_definition().kinds[0].friction = world.edit_definition().materials[0].friction =
            0.94052894293176059;
        add_capsule(world,
                    {{4.1309338014005164, 4.9396118786715899},
                     {7.1309338014005164, 4.9396118786715899},
                     0.2},
                    0);
        add_capsule(world,
                    {{5.6028427066959541, 2.9844335574553087},
                     {8.407645284116569, 2.9844335574553087},
                     0.1},
                    0);
        add_capsule(
            world,
            {{6.0201944916274037, 4.0271110974376478}, {6.0201944916274037, 2.0491410384525128}, 0},
            0);
        add_ball(world, {.position = {3, 2.2}, .velocity = {0, -4}, .radius = 0.5});
        add_ball(world, {.position = {4.56, 2.89}, .velocity = {-1, 2}, .radius = 0.5});
        add_ball(world, {.position = {5.4, 4.1}, .velocity = {5, 2}, .radius = 0.5});
        world.edit_balls().spin = {17, -3, 3};
        CHECK(ends_with_hand(world, -51.0, {1.1, 1.7}, {4.9943903145599524, 2.1040505287905988},
                             {34, -25}));
    }
}
