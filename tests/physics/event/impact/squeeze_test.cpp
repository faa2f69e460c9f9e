#include "physics/event/impact/squeeze.h"

#include <doctest/doctest.h>

#include "physics/event/motion/tolerances.h"
#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

// A held ball that touches a floor, and is to move by `displacement` in a tick of 1 s.
World held_above_a_floor(Vec2 displacement) {
    World world = scenes::empty();
    world.edit_definition().rate = 1.0;
    add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
    const BallId ball = add_ball(world, {.position = {0.0, 0.5}, .radius = 0.5});
    world.edit_held_balls().push_back({ball, Vec2{0.0, 0.5} + displacement});
    return world;
}

struct Held {
    bool can = false;
    Vector<double> velocity;
};
Held held_back(const World& world) {
    EventParts parts(world);
    parts.cluster.begin(0, {parts.scene.now, EventKind::ball_edge, 0, 0, 0, 0});
    Held held{.can = hold_back(parts.cluster, parts.balls)};
    held.velocity = parts.cluster.motion()[0].velocity;
    parts.cluster.end();
    return held;
}

}  // namespace

TEST_CASE("squeeze: a held ball goes along the edges that it touches, and not into them") {
    const Held away = held_back(held_above_a_floor({1.0, 2.0}));
    CHECK(away.can);
    CHECK(away.velocity == Vector<double>{1.0, 2.0});

    const Held along = held_back(held_above_a_floor({1.0, -2.0}));
    CHECK(along.can);
    CHECK(along.velocity == Vector<double>{1.0, 0.0});

    World corner = held_above_a_floor({1.0, -2.0});
    add_capsule(corner, {{0.5, 0.0}, {0.5, 5.0}, 0.0}, 0);
    const Held stands = held_back(corner);
    CHECK(stands.can);
    CHECK(stands.velocity == Vector<double>{});
}

TEST_CASE("squeeze: a held ball cannot be held back if one of two edges moves into it") {
    World world = held_above_a_floor({});
    const CapsuleId lid = add_capsule(world, {{-5.0, 1.0}, {5.0, 1.0}, 0.0}, 0);
    CHECK(held_back(world).can);
    world.edit_held_capsules().push_back({lid, {-5.0, 0.5}, {5.0, 0.5}});
    CHECK_FALSE(held_back(world).can);
}

TEST_CASE("squeeze: a kinematic body pushes without end if collisions with its balls do not end") {
    for (const bool is_held : {false, true}) {
        CAPTURE(is_held);
        World world = scenes::empty();
        const BallId first = add_ball(world, {.position = {0.0, 0.0}, .radius = 0.5});
        add_ball(world, {.position = {1.0, 0.0}, .radius = 0.5});
        if (is_held) world.edit_held_balls().push_back({first, {0.5, 0.0}});
        EventParts parts(world);
        const auto pushes = [&](bool is_jammed) {
            parts.cluster.begin(1, {parts.scene.now, EventKind::ball_ball, 0, 0, 0, 0});
            const bool is = pushes_without_end(parts.cluster, parts.balls, is_jammed);
            parts.cluster.end();
            return is;
        };
        CHECK_FALSE(pushes(false));
        CHECK(pushes(true) == is_held);
        parts.balls[0].line.recent_collisions = parts.balls[1].line.recent_collisions =
            most_recent_collisions;
        CHECK_FALSE(pushes(false));
        parts.balls[0].line.recent_collisions = parts.balls[1].line.recent_collisions =
            most_recent_collisions + 1;
        CHECK(pushes(false) == is_held);
    }
}
