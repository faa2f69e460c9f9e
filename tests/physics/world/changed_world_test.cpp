#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/world/fingerprint.h"

using namespace carom;

// A solver must not hold state that the next tick depends on, so it must not continue with stale
// data after a change of the world.
TEST_CASE("after any change of the world between ticks, a solver continues as a fresh one would") {
    struct Row {
        std::string what;
        std::function<void(World&)> change;
    };
    const std::vector<Row> rows{
        {"nothing", [](World&) {}},
        {"the last edge goes", [](World& w) { remove_capsule(w, w.capsules().id[1]); }},
        {"the first edge goes", [](World& w) { remove_capsule(w, w.capsules().id[0]); }},
        {"an edge comes through balls",
         [](World& w) {
             add_capsule(w, {{0.0, 0.9}, {20.0, 0.9}, 0.0}, 0);
         }},
        {"an edge moves", [](World& w) { w.edit_capsules().shape[1].start.y = 0.01; }},
        {"balls move into others", [](World& w) { w.edit_balls().position[2].x += 1.3; }},
        {"all balls move up to the edge",
         [](World& w) {
             for (Vec2& position : w.edit_balls().position)
                 position.y -= 4e-4;
         }},
        {"a ball goes", [](World& w) { remove_ball(w, w.balls().id[4]); }},
        {"a ball grows", [](World& w) { w.edit_balls().radius[3] = 1.2; }},
        {"balls meet no more", [](World& w) { w.edit_definition().model.ball_ball = false; }},
    };
    for (const SolverKind kind : solvers_available()) {
        for (const Row& row : rows) {
            CAPTURE(name(kind));
            CAPTURE(row.what);
            World seen = scenes::empty();
            seen.edit_definition().kinds[0].radius = 0.5;
            add_capsule(seen, {{-5.0, -5.0}, {-4.0, -5.0}, 0.0}, 0);
            add_capsule(seen, {{0.0, 0.0}, {20.0, 0.0}, 0.0}, 0);
            for (int i = 0; i < 8; ++i)
                add_ball(seen, {.position = {2.0 + 2.0 * i, 0.5005},
                                .velocity = {i % 3 == 0 ? 1e-3 : 0.0, -1e-2}});
            Solver solver({.kind = kind});
            for (int i = 0; i < 3; ++i)
                solver.tick(seen);
            row.change(seen);
            World unseen = seen;
            for (int i = 0; i < 60; ++i) {
                solver.tick(seen);
                Solver stranger({.kind = kind});
                stranger.tick(unseen);
                REQUIRE(fingerprint(seen) == fingerprint(unseen));
            }
        }
    }
}
