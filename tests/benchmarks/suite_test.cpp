#include "suite.h"

#include <cmath>

#include <doctest/doctest.h>

#include "level_scene.h"

using namespace carom;
using namespace carom::bench;

TEST_CASE("each run of a pile starts from its own lattice, and all other scenes are fixed") {
    int piles = 0;
    for (const BenchScene& scene : bench_scenes(false)) {
        CAPTURE(scene.name);
        CHECK(arrangement(scene, 0).empty());
        if (scene.sort != SceneSort::pile) {
            CHECK(arrangement(scene, 1).empty());
            continue;
        }
        ++piles;
        std::vector<SceneList> lists;
        for (int run = 0; run < 4; ++run) {
            std::vector<std::string> settings = scene.settings;
            const std::vector<std::string> own = arrangement(scene, run);
            settings.insert(settings.end(), own.begin(), own.end());
            const LoadedScene loaded = load_scene(
                std::string(CAROM_SOURCE_DIR) + "/benchmarks/scenes/" + scene.level, settings);
            INFO(loaded.error);
            REQUIRE(loaded.scene);
            const ListedScene listed = list_of(loaded.scene->world, scene.plan);
            REQUIRE(listed.list);
            for (const SceneList& other : lists) {
                REQUIRE(other.balls.size() == listed.list->balls.size());
                CHECK(other.balls[1].x != listed.list->balls[1].x);
                CHECK(std::abs(other.balls[1].x - listed.list->balls[1].x) < 0.002);
            }
            lists.push_back(*listed.list);
        }
    }
    CHECK(piles == 4);
}
