#pragma once

#include <string>
#include <utility>

#include <doctest/doctest.h>

#include "game/pool/pool.h"
#include "game/pool/shot_record.h"
#include "game/support/shipped.h"
#include "physics/solver.h"

namespace carom {

/// A rack in play: shoots, and waits until the shot is judged.
struct TableInPlay {
    explicit TableInPlay(const std::string& level) : TableInPlay(test::shipped_level(level)) {}
    explicit TableInPlay(Scene of)
        : scene(std::move(of)),
          world(scene.world),
          play(*begin_pool(scene)),
          solver(pick_solver(world).settings) {}

    void shoot(Vec2 velocity) {
        REQUIRE_FALSE(refusal_to_shoot(play, *play.balls[0]));
        world.edit_balls().velocity[cue()] = velocity;
        begin_shot(world, play);
        wait();
    }
    void wait() {
        for (int i = 0; play.is_shooting && i < 120 * 120; ++i)
            step();
        REQUIRE_FALSE(play.is_shooting);
    }
    void step() {
        solver.tick(world);
        update_pool(scene, world, play, solver.contacts());
    }
    std::size_t cue() const { return *index_of(world, *play.balls[0]); }
    void put(int ball, Vec2 place) {
        world.edit_balls().position[*index_of(world, *play.balls[static_cast<std::size_t>(ball)])] =
            place;
    }
    Vec2 place_of(int ball) const {
        return world.balls()
            .position[*index_of(world, *play.balls[static_cast<std::size_t>(ball)])];
    }

    Scene scene;
    World world;
    PoolPlay play;
    Solver solver;
};

}  // namespace carom
