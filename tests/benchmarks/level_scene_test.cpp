#include "level_scene.h"

#include <doctest/doctest.h>

#include "level/load.h"

using namespace carom;
using namespace carom::bench;

namespace {

ListedScene listed(const std::string& statements) {
    const LoadResult result = load_level("carom 1 \"A test\"\n" + statements, "test.level");
    REQUIRE(result.scene);
    return list_of(result.scene->world, {.ticks = 10});
}

std::string scenes() {
    return std::string(CAROM_SOURCE_DIR) + "/benchmarks/scenes/";
}

SceneList listed_file(const std::string& name, const std::vector<std::string>& overrides) {
    const LoadedScene loaded = load_scene(scenes() + name, overrides);
    INFO(loaded.error);
    REQUIRE(loaded.scene);
    const ListedScene listed = list_of(loaded.scene->world, {});
    INFO(listed.error);
    REQUIRE(listed.list);
    return *listed.list;
}

}  // namespace

TEST_CASE("a level becomes a list of its balls, edges and terms") {
    const ListedScene scene = listed(
        "rate 50\nuse gravity 0,-3\nkind k r=2 m=5 e=0.5\nmaterial w e=0.5\n"
        "ball kind=k at=1,2 v=3,4\nedge w -9,-9 9,-9 r=0.25\n");
    REQUIRE(scene.list);
    CHECK(scene.list->rate == 50.0);
    CHECK(scene.list->gravity_y == -3.0);
    CHECK(scene.list->restitution == 0.5);
    CHECK(scene.list->friction == 0.0);
    CHECK(scene.list->plan.ticks == 10);
    REQUIRE(scene.list->balls.size() == 1);
    CHECK(scene.list->balls[0].vy == 4.0);
    CHECK(scene.list->balls[0].mass == doctest::Approx(5.0).epsilon(1e-15));
    REQUIRE(scene.list->capsules.size() == 1);
    CHECK(scene.list->capsules[0].radius == 0.25);
}

TEST_CASE("balls of emitters are listed at the tick in which they appear") {
    const ListedScene scene =
        listed("rate 60\nkind k r=1\nspawn k at=0,5 v=0,-1 every=0.05 count=3\nedge -9,-9 9,-9");
    REQUIRE(scene.list);
    REQUIRE(scene.list->balls.size() == 3);
    CHECK(scene.list->balls[0].tick == 0);
    CHECK(scene.list->balls[1].tick == 3);
    CHECK(scene.list->balls[2].tick == 6);
    CHECK(scene.list->balls[2].y == 5.0);
}

TEST_CASE("features that the list cannot express are refused, not dropped") {
    CHECK_FALSE(listed("use drag 1\nball at=0,0").list);
    CHECK_FALSE(listed("ball at=0,0\nzone 9,9 9,9 r=1 sink").list);
    CHECK_FALSE(listed("material soft e=0.5\nball at=0,0\nedge soft 0,-9 9,-9").list);
}

TEST_CASE("the scenes have the number of balls that the benchmark states") {
    CHECK(listed_file("gas.level", {}).balls.size() == 1'000);
    CHECK(listed_file("gas.level", {"let n=100"}).balls.size() == 100);
    CHECK(listed_file("pile.level", {}).balls.size() == 2'000);
    const SceneList galton = listed_file("galton.level", {});
    CHECK(galton.balls.size() == 5'000);
    CHECK(galton.balls[20].tick == 4);
    CHECK(galton.balls[4'999].tick == 996);
}
