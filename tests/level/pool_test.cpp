#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "level/support/files.h"
#include "physics/solver.h"

using namespace carom;
using namespace carom::test;

namespace {

LoadResult load_shipped(std::string_view name) {
    const auto folder = std::filesystem::path(CAROM_SOURCE_DIR) / "levels";
    const std::string file = std::string(name) + ".level";
    return load_level(read_file(folder / file), file, options_for(folder));
}

Scene shipped(std::string_view name) {
    LoadResult result = load_shipped(name);
    CHECK(rendered(result).empty());
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

Vec2 place_of(const Scene& scene, int number) {
    const auto& rack = scene.pool.racks.front();
    return scene.world.balls()
        .position[*index_of(scene.world, rack.balls[static_cast<std::size_t>(number - 1)])];
}

bool is_solid(int number) {
    return number < 8;
}

}  // namespace

TEST_CASE("the 8-ball table has 16 balls, six pockets and a cue") {
    const Scene scene = shipped("eight-ball");
    CHECK(scene.game == "eightball");
    CHECK(scene.world.model().cloth);
    CHECK(scene.world.model().spin == 0.4);
    CHECK(scene.world.balls().size() == 16);
    CHECK(scene.pool.pockets.size() == 6);
    REQUIRE(scene.pool.cue);
    CHECK(scene.ball_names[number(scene.pool.cue->ball)] == "cue");
    CHECK(scene.pool.cue->least_power == 0.0);
    CHECK(scene.pool.cue->most_power == 13.0);
    CHECK(scene.ball_names[number(scene.pool.racks.front().balls[7])] == "rack.8");
}

TEST_CASE("race and clock set the length of a match and the shot clock") {
    const auto loaded = [](const std::string& statement) {
        const auto folder = std::filesystem::path(CAROM_SOURCE_DIR) / "levels";
        LoadOptions options = options_for(folder);
        options.overrides = {statement};
        LoadResult result =
            load_level(read_file(folder / "nine-ball.level"), "nine-ball.level", options);
        CHECK(rendered(result).empty());
        REQUIRE(result.scene);
        return result.scene->pool;
    };
    CHECK(loaded("game nineball").race == 0);
    CHECK(loaded("game nineball").clock == 0.0);
    CHECK(loaded("game nineball race=7 clock=0.5min").race == 7);
    CHECK(loaded("game nineball race=7 clock=0.5min").clock == 30.0);
}

TEST_CASE("an 8-ball rack has the 8 in the middle and a solid and a stripe in the back corners") {
    std::set<int> behind_the_apex;
    for (int seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        const Scene scene = load_clean("rack eight at=0,0 gap=0.01 seed=" + std::to_string(seed));
        const Vec2 eight = place_of(scene, 8);
        CHECK(eight.x == doctest::Approx(2.0 * 2.01 * 0.8660254).epsilon(0.01));
        CHECK(std::abs(eight.y) < 0.01);
        std::vector<int> corners;
        for (int ball = 1; ball <= 15; ++ball) {
            const Vec2 place = place_of(scene, ball);
            if (place.x > 6.5 && std::abs(place.y) > 3.5) corners.push_back(ball);
            if (place.x < 0.1) behind_the_apex.insert(ball);
        }
        REQUIRE(corners.size() == 2);
        CHECK(is_solid(corners[0]) != is_solid(corners[1]));
    }
    CHECK(behind_the_apex.size() > 8);
}

TEST_CASE("a 9-ball rack has the 1 at the apex and the 9 in the middle") {
    for (int seed = 0; seed < 10; ++seed) {
        const Scene scene =
            load_clean("rack nine at=5,5 toward=north seed=" + std::to_string(seed));
        CHECK(scene.world.balls().size() == 9);
        CHECK(place_of(scene, 1) == Vec2{5.0, 5.0});
        CHECK(place_of(scene, 9).x == doctest::Approx(5.0));
        CHECK(place_of(scene, 9).y == doctest::Approx(5.0 + 4.0 * 0.8660254));
    }
}

TEST_CASE(
    "no two balls of a rack touch where there is a gap, and none is further than twice of it") {
    const Scene scene = load_clean("rack triangle at=0,0 gap=0.01 seed=5");
    for (int a = 1; a <= 15; ++a) {
        int near = 0;
        for (int b = 1; b <= 15; ++b) {
            if (a == b) continue;
            const double gap = length(place_of(scene, a) - place_of(scene, b)) - 2.0;
            CHECK(gap > 0.0049);
            near += gap < 0.02;
        }
        CHECK(near >= 2);
    }
}

TEST_CASE("after a hard break, every ball is on the table or in a pocket") {
    for (const std::string_view name : {"eight-ball", "nine-ball", "pool-table"}) {
        CAPTURE(name);
        const Scene scene = shipped(name);
        std::size_t pocketed = 0;
        for (int shot = 0; shot < 12; ++shot) {
            CAPTURE(shot);
            World world = scene.world;
            const std::size_t cue = *index_of(world, scene.pool.cue->ball);
            world.edit_balls().velocity[cue] = {9.0, 0.4 * (shot - 5.5)};
            Solver solver(pick_solver(world).settings);
            const auto moves = [](Vec2 v) { return !(v == Vec2{}); };
            for (int tick = 0; tick < 60 * 120; ++tick) {
                solver.tick(world);
                if (std::ranges::none_of(world.balls().velocity, moves)) break;
            }
            CHECK(std::ranges::none_of(world.balls().velocity, moves));
            CHECK(world.balls().size() + world.ledger().removed.size() ==
                  scene.world.balls().size());
            pocketed += world.ledger().removed.size();
            for (const Vec2 place : world.balls().position) {
                CHECK(std::abs(place.x) < 1.27 + 0.06);
                CHECK(std::abs(place.y) < 0.635 + 0.06);
            }
        }
        CHECK(pocketed > 0);
    }
}
