#include "terminal/draw/trails.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace carom;

namespace {

struct Path {
    World world;
    Camera camera = fit_camera({{0, 0}, {20, 10}}, {0, 0, 40, 10}, 2.0);
    Trails trails;

    Path() {
        world.edit_definition().kinds.resize(1);
        BallSpec spec;
        spec.position = {2, 5};
        add_ball(world, spec);
    }
    void move_to(Vec2 position) {
        world.edit_balls().position[0] = position;
        ++world.edit_tick();
    }
    void draw() {
        const Raster raster(braille_renderer(), 40, 10, 2.0);
        const std::vector<Ink> inks(world.balls().size(), Ink{3, plain});
        add_to_trails(trails, camera, raster, world, inks);
    }
    long lit() const {
        return std::count_if(trails.levels.begin(), trails.levels.end(),
                             [](std::uint8_t level) { return level > 0; });
    }
    std::uint8_t freshest() const {
        return *std::max_element(trails.levels.begin(), trails.levels.end());
    }
};

}  // namespace

TEST_CASE("a ball leaves a trail without gaps, however far it moves between pictures") {
    Path path;
    path.draw();
    path.move_to({18, 5});
    path.draw();
    // 16 lengths are 30.4 columns of 2 dots.
    CHECK(path.lit() >= 61);
    CHECK(path.lit() <= 63);
}

TEST_CASE("trails fade while the world runs, and stay while it is paused") {
    Path path;
    path.draw();
    path.draw();
    CHECK(path.freshest() == 255);
    path.world.edit_balls() = {};
    ++path.world.edit_tick();
    path.draw();
    CHECK(path.freshest() < 255);
    for (int i = 0; i < 100; ++i) {
        ++path.world.edit_tick();
        path.draw();
    }
    CHECK(path.lit() == 0);
}

TEST_CASE("a step back fades like a step forward") {
    Path path;
    path.world.edit_tick() = 5;
    path.draw();
    path.world.edit_balls() = {};
    path.world.edit_tick() = 4;
    path.draw();
    CHECK(path.freshest() < 255);
}

TEST_CASE("another camera clears trails") {
    Path path;
    path.draw();
    path.move_to({18, 5});
    path.draw();
    path.camera = panned(path.camera, 1.0, 0.0);
    path.draw();
    CHECK(path.lit() == 1);
}

TEST_CASE("a ball that crosses a side of a torus draws no line across") {
    Path path;
    path.world.edit_definition().model.wrap = Box{{0, 0}, {20, 10}};
    path.draw();
    path.move_to({19, 5});
    path.draw();
    CHECK(path.lit() == 2);
}

TEST_CASE("a new ball starts where it is, and a removed one leaves its trail") {
    Path path;
    path.draw();
    BallSpec spec;
    spec.position = {10, 8};
    add_ball(path.world, spec);
    remove_ball(path.world, BallId{0});
    ++path.world.edit_tick();
    path.draw();
    CHECK(path.lit() == 2);
    REQUIRE(path.trails.places.size() == 1);
    CHECK(path.trails.places[0].id == BallId{1});
}

TEST_CASE("trails are fainter than balls") {
    Path path;
    path.draw();
    Raster raster(half_block_renderer(), 40, 10, 2.0);
    const std::vector<Ink> inks(1, Ink{3, plain});
    add_to_trails(path.trails, path.camera, raster, path.world, inks);
    paint_trails(raster, path.trails, {});
    int brightest = 0;
    for (int down = 0; down < raster.samples_down(); ++down) {
        for (int across = 0; across < raster.samples_across(); ++across) {
            brightest = std::max(brightest, int{raster.level_at(across, down)});
        }
    }
    CHECK(brightest == 170);
}
