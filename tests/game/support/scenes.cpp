#include "game/support/scenes.h"

namespace carom::test {
namespace {

void add_balls(World& world) {
    for (int i = 0; i < 9; ++i) {
        const double column = i % 3;
        const double row = i / 3;
        add_ball(world, {.kind = 0,
                         .position = {8.0 + 5.0 * column, 8.0 + 5.0 * row},
                         .velocity = {30.0 - 11.0 * column + row, 17.0 * row - 9.0 - column},
                         .radius = std::nullopt,
                         .mass = 1.0 + 0.25 * i,
                         .restitution = std::nullopt});
    }
}

void add_free_edges(World& world) {
    add_capsule(world, {{24.0, 4.0}, {34.0, 7.0}, 0.5}, 0);
    add_capsule(world, {{25.0, 24.0}, {30.0, 20.0}, 0.5}, 0);
    add_capsule(world, {{30.0, 20.0}, {36.0, 25.0}, 0.5}, 0);
}

}  // namespace

Scene busy_box() {
    Scene scene;
    scene.file = "busy.level";
    scene.title = "Busy box";
    scene.files = {scene.file};
    scene.texts = {"carom 1 \"Busy box\"\n"};
    scene.text_hash = 0x1234;
    scene.view = {{0.0, 0.0}, {40.0, 30.0}};
    World& world = scene.world;
    world.edit_definition().kinds = {Kind{.radius = 1.0, .mass = 1.0, .restitution = 1.0}};
    world.edit_definition().materials = {Material{}};
    scene.kind_names = {"ball"};
    scene.material_names = {"edge"};
    add_balls(world);
    const Vec2 corners[] = {{0.0, 0.0}, {40.0, 0.0}, {40.0, 30.0}, {0.0, 30.0}};
    for (int i = 0; i < 4; ++i)
        add_capsule(world, {corners[i], corners[(i + 1) % 4], 1.0}, 0);
    add_free_edges(world);
    return scene;
}

Scene rainy_torus() {
    Scene scene = busy_box();
    World& world = scene.world;
    world = World{};
    world.edit_definition().kinds = {Kind{.radius = 1.0, .mass = 1.0, .restitution = 0.8}};
    world.edit_definition().materials = {Material{.restitution = 0.7}};
    world.edit_definition().model.inelastic = true;
    world.edit_definition().model.gravity = Vec2{0.0, -20.0};
    world.edit_definition().model.wrap = scene.view;
    add_balls(world);
    add_free_edges(world);
    return scene;
}

BallSpec ball_at_rest(Vec2 place) {
    BallSpec spec;
    spec.position = place;
    return spec;
}

}  // namespace carom::test
