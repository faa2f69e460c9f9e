#include "judge.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

using namespace carom;
using namespace carom::bench;

namespace {

// Two discs of radius 1 and mass 1 that separate, each at speed 1.
struct Pair {
    World world;
    SceneList list;
    Frame frame{.tick = 6, .balls = {{-2.0, 0.0, -1.0, 0.0}, {2.0, 0.0, 1.0, 0.0}}};

    Pair() {
        world.edit_definition().kinds.push_back({});
        for (const BallState& ball : frame.balls) {
            list.balls.push_back({.x = ball.x, .vx = ball.vx});
            add_ball(world, {.position = {ball.x, ball.y},
                             .velocity = {ball.vx, ball.vy},
                             .radius = 1.0,
                             .mass = 1.0});
        }
    }
};

}  // namespace

TEST_CASE("a run identical to the reference has no error, no drift and no overlap") {
    const Pair pair;
    const Accuracy accuracy = judge(pair.world, pair.list, {pair.frame}, pair.frame);
    CHECK(accuracy.error == 0.0);
    CHECK(accuracy.energy_drift == 0.0);
    CHECK(accuracy.deepest_overlap == 0.0);
    CHECK(accuracy.residual_speed == 1.0);
}

TEST_CASE("drift, overlap, residual speed and error are computed from the frames") {
    const Pair pair;
    Frame seen = pair.frame;
    seen.balls[0] = {1.5, 0.0, -2.0, 0.0};
    const Accuracy accuracy = judge(pair.world, pair.list, {seen}, pair.frame);
    CHECK(accuracy.deepest_overlap == doctest::Approx(1.5).epsilon(1e-12));
    CHECK(*accuracy.energy_drift == doctest::Approx(1.5).epsilon(1e-12));  // from 1 to 2.5
    CHECK(accuracy.residual_speed == doctest::Approx(std::sqrt(2.5)).epsilon(1e-12));
    CHECK(*accuracy.error == doctest::Approx(std::sqrt(3.5 * 3.5 / 2)).epsilon(1e-12));
}

TEST_CASE("frames before the judged ones count only in the error") {
    Pair pair;
    pair.list.plan.measured_from = 100;
    Frame later = pair.frame;
    later.tick = 100;
    Frame overlapping = pair.frame;
    overlapping.balls[0].x = 1.5;
    const Accuracy accuracy = judge(pair.world, pair.list, {overlapping, later}, pair.frame);
    CHECK(accuracy.deepest_overlap == 0.0);
    CHECK(*accuracy.error > 1.0);
}

TEST_CASE("a dissipative scene has no drift") {
    Pair pair;
    pair.list.restitution = 0.5;
    CHECK_FALSE(judge(pair.world, pair.list, {pair.frame}, {}).energy_drift);
}

TEST_CASE("frames are read back as written, and a truncated file has none") {
    const Pair pair;
    const std::string path = std::string(CAROM_BINARY_DIR) + "/judge_test.frames";
    {
        std::ofstream file(path, std::ios::binary);
        write_frame(file, pair.frame);
        write_frame(file, pair.frame);
        file.write("short", 5);
    }
    const auto frames = read_frames(path);
    std::remove(path.c_str());
    REQUIRE(frames.size() == 2);
    CHECK(frames[1].tick == 6);
    CHECK(frames[1].balls[1].vx == 1.0);
    CHECK(read_frames(path).empty());
}
