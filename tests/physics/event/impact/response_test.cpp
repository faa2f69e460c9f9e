#include "physics/event/impact/response.h"

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
        world.edit_definition().model.lossy = true;
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
