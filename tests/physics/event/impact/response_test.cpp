#include "physics/event/impact/response.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "physics/event/motion/tolerances.h"
#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

TEST_CASE("response: in a row of touching balls the last one leaves with the whole momentum") {
    World world = scenes::empty();
    add_ball(world, {.position = {-1.0, 0.0}, .velocity = {2.0, 0.0}, .radius = 0.5});
    for (int i = 0; i < 3; ++i)
        add_ball(world, {.position = {double(i), 0.0}, .radius = 0.5});
    EventParts parts(world);
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched(4);
    const std::vector<std::uint32_t> changed = parts.response.resolve(
        0, {parts.scene.now, EventKind::ball_ball, 0, 0, 1, 0}, {contacts, touched});
    parts.cluster.end();
    CHECK(changed == std::vector<std::uint32_t>{0, 1, 2, 3});
    for (std::uint32_t i = 0; i < 4; ++i)
        CHECK(parts.balls[i].line.velocity.x == (i == 3 ? 2.0 : 0.0));
    CHECK(contacts.size() == 3);
    CHECK(touched == std::vector<std::uint8_t>{1, 1, 1, 1});
}

TEST_CASE("response: balls that overlap under pressure are separated, but never into an edge") {
    for (const bool is_barred : {false, true}) {
        CAPTURE(is_barred);
        World world = scenes::empty();
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().model.inelastic = true;
        const double depth = 2.0 * moving_rest_height;
        add_ball(world, {.position = {0.0, 0.0}, .velocity = {0.5, 0.0}, .radius = 0.5});
        add_ball(world, {.position = {1.0 - depth, 0.0}, .velocity = {-0.5, 0.0}, .radius = 0.5});
        if (is_barred) add_capsule(world, {{1.5 - depth, -5.0}, {1.5 - depth, 5.0}, 0.0}, 0);
        EventParts parts(world);
        std::vector<Contact> contacts;
        std::vector<std::uint8_t> touched(2);
        parts.response.resolve(0, {parts.scene.now, EventKind::ball_ball, 0, 0, 1, 0},
                               {contacts, touched});
        parts.cluster.end();
        const double left = parts.balls[0].line.position.x;
        const double right = parts.balls[1].line.position.x;
        CHECK(right - left == doctest::Approx(1.0).epsilon(1e-12));
        CHECK((right > 1.0 - 0.9 * depth) == !is_barred);
    }
}

// Regression: a ball at distant coordinates was pushed into the edge by up to their rounding, and
// in every impact anew (check-scenes 4002023).
TEST_CASE("response: balls far from the origin are separated, but never into an edge") {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.inelastic = true;
    const Vec2 far{1e6, 1e6};
    const double radius = 1e-3;
    const double depth = 2.0 * moving_rest_height * radius;
    const double right = far.x + 2.0 * radius - depth;
    add_ball(world, {.position = far, .velocity = {0.5, 0.0}, .radius = radius});
    add_ball(world, {.position = {right, far.y}, .velocity = {-0.5, 0.0}, .radius = radius});
    add_capsule(world, {{right + radius, far.y - 5.0}, {right + radius, far.y + 5.0}, 0.0}, 0);
    EventParts parts(world);
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched(2);
    parts.response.resolve(0, {parts.scene.now, EventKind::ball_ball, 0, 0, 1, 0},
                           {contacts, touched});
    parts.cluster.end();
    CHECK(parts.balls[0].line.position.x < far.x);
    CHECK(parts.balls[1].line.position.x == right);
}

// Regression: balls that edges barred were not separated at all. A ball that leaned on a wall and
// on another one on the floor sank into it impact by impact (check-scenes 1483, 1750, 2665).
TEST_CASE("response: balls that a wall and a floor bar separate along these") {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.inelastic = true;
    const double depth = 100.0 * moving_rest_height;
    const Vec2 normal{-0.8, 0.6};  // from the ball on the floor to the one at the wall
    add_capsule(world, {{-5.0, -0.5}, {5.0, -0.5}, 0.0}, 0);
    const Vec2 high = normal * (1.0 - depth);
    add_capsule(world, {{high.x - 0.5, -0.5}, {high.x - 0.5, 5.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 0.0}, .velocity = normal, .radius = 0.5});
    add_ball(world, {.position = high, .velocity = -normal, .radius = 0.5});
    EventParts parts(world);
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched(2);
    parts.response.resolve(0, {parts.scene.now, EventKind::ball_ball, 0, 0, 1, 0},
                           {contacts, touched});
    parts.cluster.end();
    const Vec2 low(parts.balls[0].line.position);
    const Vec2 there(parts.balls[1].line.position);
    CHECK(std::fabs(low.y) < 1e-15);
    CHECK(there.x == doctest::Approx(high.x).epsilon(1e-15));
    CHECK(1.0 - distance(low, there) < 0.01 * depth);
}

// Regression: a ball that slides over one on the floor was lifted again and again, 1e-7 of its
// energy at a time.
TEST_CASE("response: balls that are lifted apart pay for it with their speed") {
    for (const double speed : {1.0, 1e-3}) {
        CAPTURE(speed);
        World world = scenes::empty();
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().model.inelastic = true;
        const double depth = 1e-3;
        const Vec2 normal{0.6, 0.8};
        add_ball(world, {.position = {0.0, 0.5}, .velocity = {speed, 0.0}, .radius = 0.5});
        add_ball(world, {.position = Vec2{0.0, 0.5} + normal * (1.0 - depth),
                         .velocity = {-speed, 0.0},
                         .radius = 0.5});
        add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
        EventParts parts(world);
        const auto energy = [&] {
            double sum = 0.0;
            for (std::uint32_t i = 0; i < 2; ++i)
                sum += 0.5 * length_squared(parts.balls[i].line.velocity) +
                       10.0 * parts.balls[i].line.position.y;
            return sum;
        };
        const double before = energy();
        std::vector<Contact> contacts;
        std::vector<std::uint8_t> touched(2);
        parts.response.resolve(0, {parts.scene.now, EventKind::ball_ball, 0, 0, 1, 0},
                               {contacts, touched});
        parts.cluster.end();
        CHECK(energy() == doctest::Approx(before).epsilon(1e-15));
        const double gap =
            length(parts.balls[1].line.position - parts.balls[0].line.position) - 1.0;
        // Slow balls have too little energy to be lifted all of the way.
        CHECK((gap > -0.01 * depth) == (speed == 1.0));
        CHECK(gap > -depth);
        CHECK(gap < 0.01 * depth);
    }
}

TEST_CASE("response: a resting ball that is hit releases the balls that rest on it") {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
    add_capsule(world, {{-0.5, 0.0}, {-0.5, 10.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 0.5}, .radius = 0.5});
    add_ball(world, {.position = {0.0, 1.5}, .radius = 0.5});
    add_ball(world, {.position = {1.0, 0.5}, .velocity = {-2.0, 0.0}, .radius = 0.5});
    EventParts parts(world);
    for (std::uint32_t i = 0; i < 2; ++i) {
        parts.rest.settle(i);
        REQUIRE(parts.balls[i].line.motion == Motion::resting);
    }
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched(3);
    const std::vector<std::uint32_t> changed = parts.response.resolve(
        2, {parts.scene.now, EventKind::ball_ball, 0, 0, 0, 0}, {contacts, touched});
    parts.cluster.end();
    CHECK(changed == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("response: balls that are separated across a border of cells change their cells") {
    // The border between two cells, where the grid of these three balls has it.
    const double depth = 2.0 * moving_rest_height;
    const auto pressed_at = [&](double border) {
        World world = scenes::empty();
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().model.inelastic = true;
        const double left = border + 0.25 * depth;
        add_ball(world, {.position = {left, 0.0}, .velocity = {0.5, 0.0}, .radius = 0.5});
        add_ball(world,
                 {.position = {left + 1.0 - depth, 0.0}, .velocity = {-0.5, 0.0}, .radius = 0.5});
        add_ball(world, {.position = {-50.0, -50.0}, .radius = 0.5});
        add_ball(world, {.position = {50.0, 50.0}, .radius = 0.5});
        return world;
    };
    const EventParts grid(pressed_at(0.0));
    const CellFrame frame = grid.space.cells().frame();
    const double border = frame.origin.x + frame.cell.x * frame.column(0.0);
    EventParts parts(pressed_at(border));
    REQUIRE(parts.space.cells().frame() == frame);
    const std::uint32_t before = parts.balls.plan(0).place.cell;
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched(4);
    parts.response.resolve(0, {parts.scene.now, EventKind::ball_ball, 0, 0, 1, 0},
                           {contacts, touched});
    parts.cluster.end();
    REQUIRE(parts.balls[0].line.position.x < border);
    CHECK(parts.balls.plan(0).place.cell + 1 == before);
}
