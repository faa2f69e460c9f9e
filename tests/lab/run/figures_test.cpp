#include "lab/run/figures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "lab/support/load.h"
#include "physics/solver.h"

using namespace carom;

namespace {

const Figure& figure(std::string_view key) {
    return *std::ranges::find(figures(), key, &Figure::key);
}

}  // namespace

TEST_CASE("each field of a report is one figure, and each figure is available somewhere") {
    std::set<std::string_view> keys;
    for (const Figure& each : figures()) {
        CAPTURE(each.key);
        CHECK(keys.insert(each.key).second);
        CHECK((each.of_run != nullptr) == (each.quantity == nullptr));
        CHECK((each.is_in_run || each.is_in_measure));
        CHECK(each.is_in_measure == !each.head.empty());
    }
    CHECK(keys ==
          std::set<std::string_view>{"energy_drift", "momentum_drift", "max_overlap", "escaped"});
}

TEST_CASE("overlap is the deepest at the end of any tick so far") {
    const Scene scene = test::load("ball a at=0,0 r=1\nball b at=3,0 r=1\n");
    RunWatch watch(scene, RunWatch::Conservation::ignored);
    World world = scene.world;
    CHECK(watch.value(figure("max_overlap"), world) == 0.0);
    world.edit_balls().position[1] = {1.5, 0.0};
    watch.note_tick(world);
    world.edit_balls().position[1] = {3.0, 0.0};
    watch.note_tick(world);
    CHECK(watch.value(figure("max_overlap"), world) == 0.5);
}

TEST_CASE("drifts have no value unless they are recorded") {
    const Scene scene = test::load("ball a at=0,0 v=1,0\n");
    const RunWatch watch(scene, RunWatch::Conservation::ignored);
    CHECK_FALSE(watch.value(figure("energy_drift"), scene.world));
    CHECK_FALSE(watch.value(figure("momentum_drift"), scene.world));
}

TEST_CASE("drifts are recorded on request") {
    const Scene scene = test::load("ball a at=0,0 v=1,0\n");
    RunWatch watch(scene, RunWatch::Conservation::noted);
    World world = scene.world;
    world.edit_balls().velocity[0] = {2.0, 0.0};
    watch.note_tick(world);
    CHECK(watch.value(figure("energy_drift"), world) == 0.75);
    CHECK(watch.value(figure("momentum_drift"), world) == 0.5);
    CHECK_FALSE(RunWatch(scene, RunWatch::Conservation::ignored).conservation());
}

TEST_CASE("a figure without a value is null, and a count has no decimal point") {
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::one_line);
    write_figure(json, figure("escaped"), 3.0);
    write_figure(json, figure("max_overlap"), 3.0);
    write_figure(json, figure("energy_drift"), std::nullopt);
    json.end_object();
    CHECK(std::move(json).text() ==
          "{\"escaped\": 3, \"max_overlap\": 3.0, \"energy_drift\": null}\n");
}
