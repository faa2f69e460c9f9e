#pragma once

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "game/pinball/pinball.h"
#include "game/session/game_state.h"
#include "level/load.h"
#include "physics/solver.h"

namespace carom::test {

// A ball floats in a closed box without gravity, so that a test can send it anywhere.
inline const std::string small_table = R"(carom 1 "A small table"
units mm
rate 1000
box 0,0 400,600 r=1
ball b at=200,300 r=10 m=80g
droptarget drops 20,100 20,140  20,160 20,200
target stand 380,100 380,140
bumper pops at=200,500 r=20 kick=0.8m/s
rollover lanes at=100,300 at=300,300 r=12
kickback rescue at=60,50 dir=up speed=2m/s r=15
lamp arrow at=200,200
plunger spring at=390,20 dir=up speed=0.5m/s..2.5m/s width=10
drain out 150,20 250,20 r=12
flipper left at=100,60 length=50 r=5
)";

inline Scene scene_of(const std::string& text) {
    LoadResult loaded = load_level(text, "table.level", {});
    for (const Diagnostic& diagnostic : loaded.diagnostics)
        MESSAGE(diagnostic.line, ": ", diagnostic.message);
    REQUIRE(loaded.scene.has_value());
    return std::move(*loaded.scene);
}

/// A table whose ball a test moves about, with the rules of the test.
struct SmallTable {
    explicit SmallTable(const std::string& rules)
        : scene(scene_of(small_table + rules)),
          world(scene.world),
          game(begin_game(scene)),
          solver(pick_solver(scene.world).settings) {}

    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * world.rate()); ++i) {
            solver.tick(world);
            update_game(scene, world, game, solver.contacts());
        }
    }
    /// Places the first ball, with a velocity, and simulates half a second.
    void send(Vec2 millimetres, Vec2 velocity, double seconds = 0.05) {
        world.edit_balls().position[0] = millimetres * 0.001;
        world.edit_balls().velocity[0] = velocity;
        run(seconds);
    }
    void press(Button button, bool is_down) {
        execute(scene, world, game, command::Press{button, is_down});
    }
    const PinballState& state() const { return std::get<PinballState>(game); }

    Scene scene;
    World world;
    GameState game;
    Solver solver;
};

}  // namespace carom::test
