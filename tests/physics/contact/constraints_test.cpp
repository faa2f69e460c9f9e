#include "physics/contact/constraints.h"

#include <doctest/doctest.h>

#include "physics/contact/energy.h"
#include "physics/contact/substep_parts.h"

namespace carom {
namespace {

// A ball of radius 0.5 and mass 1 that lies `overlap` deep in a floor, whose impulse of the last
// substep holds its weight.
struct RestingBall : SubstepParts {
    ContactKinematics kinematics;
    ContactClassification classification{step, bodies, pairs, kinematics};
    ContactEnergy energy{step, bodies, pairs};
    ContactConstraints constraints{step, bodies, pairs, classification, energy};

    explicit RestingBall(double overlap) {
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        world.edit_definition().model.inelastic = true;
        world.edit_definition().kinds = {{.radius = 0.5, .mass = 1.0, .restitution = 0.0}};
        world.edit_definition().materials = {{.restitution = 0.0}};
        add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
        add_ball(world, {.position = {0.0, 0.5 - overlap}});
        load();
        pairs.all().front().impulse = 10.0 * step.duration;
    }

    /// The ball's velocity upwards after the first iteration of a substep. `owed`: the energy that
    /// constraints have given beyond what they took.
    double velocity_after_solving(double owed) {
        energy.begin_tick(-owed);
        bodies.integrate_velocities(world, step);
        classification.count_contacts(true);
        classification.classify(world);
        constraints.begin();
        return bodies.body.front().velocity.y;
    }
};

constexpr double overlap = 0.01;

}  // namespace

TEST_CASE("contact: constraints open overlaps while they owe no energy") {
    CHECK(RestingBall(overlap).velocity_after_solving(0.0) > 1e-3);
}

// The ball has an energy of 5, of which constraints may owe a thousandth.
TEST_CASE("contact: constraints that owe energy hold their load, but open no overlap") {
    CHECK(RestingBall(overlap).velocity_after_solving(0.001) > 1e-3);
    CHECK(RestingBall(overlap).velocity_after_solving(0.1) == doctest::Approx(0.0).epsilon(1e-12));
}

TEST_CASE("contact: constraints that owe energy open deep overlaps all the same") {
    CHECK(RestingBall(0.2).velocity_after_solving(0.1) > 1e-3);
}

}  // namespace carom
