#include "game/session/conserved.h"

#include <doctest/doctest.h>

#include "game/support/scenes.h"

using namespace carom;
using carom::test::busy_box;
using carom::test::rainy_torus;

TEST_CASE("an elastic box conserves energy, and its walls take momentum") {
    World world = busy_box().world;
    CHECK(conserves_energy(world));
    CHECK_FALSE(conserves_momentum(world));
    world.edit_capsules() = {};
    CHECK(conserves_momentum(world));
    world.edit_definition().model.gravity = Vec2{0.0, -1.0};
    CHECK(conserves_energy(world));
    CHECK_FALSE(conserves_momentum(world));
}

TEST_CASE("losses, limits, emitters, sinks and held balls end the conservation of energy") {
    const World closed = busy_box().world;
    const auto with = [&](auto change) {
        World world = closed;
        change(world);
        return conserves_energy(world);
    };
    CHECK_FALSE(with([](World& w) { w.edit_definition().model.inelastic = true; }));
    CHECK_FALSE(with([](World& w) {
        w.edit_definition().model.spin = 0.5;
        w.edit_definition().model.rough = true;
    }));
    CHECK_FALSE(with([](World& w) { w.edit_definition().model.drag = 0.1; }));
    CHECK_FALSE(with([](World& w) { w.edit_definition().model.stop_speed = 0.1; }));
    CHECK_FALSE(with([](World& w) { w.edit_definition().model.speed_limit = 10.0; }));
    CHECK_FALSE(with([](World& w) { w.edit_held_balls().push_back({}); }));
    CHECK_FALSE(with([](World& w) { w.edit_held_capsules().push_back({}); }));
    CHECK_FALSE(with([](World& w) {
        w.edit_definition().zones.push_back({{}, Zone::Effect::sink, 0});
    }));
    CHECK(with([](World& w) {
        w.edit_definition().zones.push_back({{}, Zone::Effect::census, 0});
    }));
    Emitter emitter;
    emitter.count = 3;
    CHECK_FALSE(with([&](World& w) { w.edit_emitters() = {emitter}; }));
    emitter.emitted = 3;
    CHECK(with([&](World& w) { w.edit_emitters() = {emitter}; }));
    CHECK_FALSE(conserves_energy(rainy_torus().world));
}
