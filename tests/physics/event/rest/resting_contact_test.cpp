#include "physics/event/rest/resting_contact.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

World on_floor(Vec2 floor_end, Vec2 position, Vec2 velocity) {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.inelastic = true;
    add_capsule(world, {{-10.0, 0.0}, floor_end, 0.0}, 0);
    add_ball(world, {.position = position, .velocity = velocity, .radius = 0.5});
    return world;
}

}  // namespace

TEST_CASE("resting contact: a ball on a level floor rests, slides, or flies off") {
    const auto motion_of = [](Vec2 position, Vec2 velocity) {
        EventParts parts(on_floor({10.0, 0.0}, position, velocity));
        parts.rest.settle(0);
        return parts.balls[0].line.motion;
    };
    CHECK(motion_of({0.0, 0.5}, {}) == Motion::resting);
    CHECK(motion_of({0.0, 0.5}, {1.0, 0.0}) == Motion::sliding);
    // A hop of 1e-10 radii does not count; one of 1e-8 does.
    CHECK(motion_of({0.0, 0.5}, {0.0, 3e-5}) == Motion::resting);
    CHECK(motion_of({0.0, 0.5}, {0.0, 3e-4}) == Motion::free);
    CHECK(motion_of({0.0, 0.5 + 1e-6}, {}) == Motion::free);
}

TEST_CASE("resting contact: a slope gives the component of gravity along it") {
    EventParts parts(on_floor({10.0, -20.0}, {0.0, 0.0}, {}));
    const Edge<double> edge(parts.world.capsules().shape[0], {});
    const auto contact = contact_with(edge, Vector<double>{0.0, 0.0}, 0.5);
    const Vector<double> touching = Vector<double>{0.0, 0.0} - contact.normal * contact.gap;
    parts.trajectories.start(0, parts.scene.now, touching, {});
    parts.rest.settle(0);
    CHECK(parts.balls[0].line.motion == Motion::sliding);
    CHECK(length(parts.balls.curve(0).acceleration) ==
          doctest::Approx(10.0 * std::sqrt(0.5)).epsilon(1e-12));
}

TEST_CASE(
    "resting contact: two supports hold a ball, and a ball resting on it is released with it") {
    World world = on_floor({10.0, 0.0}, {0.0, 0.5}, {});
    add_capsule(world, {{-0.5, 0.0}, {-0.5, 10.0}, 0.0}, 0);
    add_ball(world, {.position = {0.0, 1.5}, .radius = 0.5});
    add_ball(world, {.position = {5.0, 0.5}, .radius = 0.5});
    EventParts parts(world);
    for (std::uint32_t i = 0; i < 3; ++i)
        parts.rest.settle(i);
    for (std::uint32_t i = 0; i < 3; ++i)
        CHECK(parts.balls[i].line.motion == Motion::resting);
    std::vector<std::uint32_t> released;
    parts.rest.release_supported(0, released);
    CHECK(released == std::vector<std::uint32_t>{1});
    CHECK(parts.balls[1].line.motion == Motion::free);
    CHECK(parts.balls[2].line.motion == Motion::resting);
}
