#include "physics/contact/press_groups.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "physics/contact/substep_parts.h"

namespace carom {
namespace {

// Two balls of radius 0.5 and mass 1, one above the other, over a floor at a height of 0. The
// upper one has just been lifted by 0.1, as a constraint with the floor does it.
struct LiftedBall : SubstepParts {
    PressGroups groups{step, bodies, pairs};
    std::uint32_t floor = 0;  // the constraint that lifted it, by pair
    std::uint32_t upper = 0;
    std::uint32_t lower = 0;

    LiftedBall(double height_of_lower, double rise_of_lower) {
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().kinds = {{.radius = 0.5, .mass = 1.0}};
        add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
        add_ball(world, {.position = {0.0, 1.6}});
        add_ball(world, {.position = {0.0, height_of_lower}});
        load();
        upper = body_of(0);
        lower = body_of(1);
        bodies.start_velocity.assign(bodies.body.size(), {});
        bodies.displacement.assign(bodies.body.size(), {});
        bodies.displacement[upper] = {0.0, 0.1};
        bodies.displacement[lower] = {0.0, rise_of_lower};
        floor = pairs.size();
        pairs.all().push_back(ContactPair{.a = upper, .b = bodies.fixed, .impulse = 1.0});
    }

    std::uint32_t body_of(std::uint32_t ball) const {
        return static_cast<std::uint32_t>(std::ranges::find(bodies.ball, ball) -
                                          bodies.ball.begin());
    }
    void find() {
        groups.find({&floor, 1});
        groups.join_followers();
    }
    bool are_joined() const { return groups.index_of(upper) == groups.index_of(lower); }
};

}  // namespace

TEST_CASE("press groups: a ball that has followed another one goes back with it") {
    LiftedBall scene(0.6, 0.1);
    scene.find();
    CHECK(scene.are_joined());
    CHECK(scene.groups.of(scene.lower).goes_back());
    CHECK(scene.groups.of(scene.lower).lift == doctest::Approx(2.0));
    // Constraints have given the energy of one ball only.
    CHECK(scene.groups.of(scene.lower).gain == doctest::Approx(1.0));
    CHECK(scene.groups.gains() == doctest::Approx(1.0));
    CHECK(scene.groups.is_pressed(scene.upper));
    CHECK_FALSE(scene.groups.is_pressed(scene.lower));
}

TEST_CASE("press groups: a ball that leaves room stays where it is") {
    LiftedBall scene(0.5, 0.1);
    scene.find();
    CHECK_FALSE(scene.are_joined());
    CHECK(scene.groups.of(scene.upper).goes_back());
    CHECK_FALSE(scene.groups.of(scene.lower).goes_back());
}

TEST_CASE("press groups: a fast ball is in the way") {
    LiftedBall scene(0.6, 0.1);
    scene.bodies.body[scene.lower].velocity = {0.0, 24.0};
    scene.find();
    CHECK_FALSE(scene.are_joined());
    CHECK_FALSE(scene.groups.of(scene.upper).goes_back());
}

TEST_CASE("press groups: groups last until they are forgotten, their sums for a substep") {
    LiftedBall scene(0.6, 0.1);
    scene.find();
    scene.bodies.displacement[scene.lower] = {};
    scene.bodies.position[scene.lower] = {0.0, 0.3};
    scene.pairs[scene.floor].impulse = 0.0;
    scene.pairs[scene.floor].target = 1.0;
    scene.find();
    CHECK(scene.groups.is_pressed(scene.upper));
    CHECK_FALSE(scene.are_joined());
    CHECK(scene.groups.of(scene.upper).gain == doctest::Approx(1.0));
    scene.groups.forget();
    scene.find();
    CHECK_FALSE(scene.groups.is_pressed(scene.upper));
}

}  // namespace carom
