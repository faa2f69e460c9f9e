#include <doctest/doctest.h>

#include <string>

#include "geometry/elementary.h"
#include "level/load.h"

// `motion`: what the loader makes of it. tests/level/broken/motions.level has the errors.

using namespace carom;

namespace {

Scene loaded(const std::string& text) {
    LoadResult result =
        load_level("carom 1 \"Motions\"\n" + text + "ball a at=900,900 r=1\n", "m.level");
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.severity == Severity::error) FAIL(render(diagnostic));
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

}  // namespace

TEST_CASE("motions: each moves all edges of its names, from home") {
    const Scene scene = loaded(
        "edge name=blades 10,10 20,10 r=1\n"
        "edge name=other 0,0 1,0\n"
        "edge name=blades 10,10 10,20 15,25 r=1\n"
        "peg name=hub at=10,10 r=2\n"
        "motion turn blades hub about=10,10 every=8 clockwise time=2\n");
    REQUIRE(scene.world.movers().size() == 1);
    CHECK(scene.mover_names == std::vector<std::string>{"blades"});
    const Mover& mover = scene.world.movers()[0];
    CHECK(mover.angle == doctest::Approx(-2.0 * pi));
    CHECK(mover.is_round);
    CHECK(mover.runs);
    CHECK(mover.clock == 2.0);
    REQUIRE(mover.edges.size() == 4);
    CHECK(mover.edges[0].home == Capsule{{10.0, 10.0}, {20.0, 10.0}, 1.0});
    // After a quarter of a round, clockwise.
    for (const MovedEdge& edge : mover.edges)
        CHECK(scene.world.capsules().shape[*index_of(scene.world, edge.capsule)] ==
              mover_shape(mover, edge, 2.0));
    CHECK(length(scene.world.capsules().shape[0].end - Vec2{10.0, 0.0}) < 1e-14);
    CHECK(is_moved_by_mover(scene.world, scene.world.capsules().id[0]));
    CHECK_FALSE(is_moved_by_mover(scene.world, scene.world.capsules().id[1]));
}

TEST_CASE("motions: swing, slide and path") {
    const Scene scene = loaded(
        "units cm\n"
        "edge name=door 0,0 0,100\n"
        "edge name=lift 0,300 100,300\n"
        "box name=car 300,300 400,400\n"
        "box name=bus 600,600 700,700\n"
        "motion swing door about=0,0 by=-90deg every=2s stops=2 waits\n"
        "motion slide lift by=0,50 every=500ms steady\n"
        "motion path car 10,10 10,60 60,60 every=3s\n"
        "motion path bus 0,0 0,50 50,50 every=3s close\n");
    const std::vector<Mover>& movers = scene.world.movers();
    REQUIRE(movers.size() == 4);
    CHECK(movers[0].angle == -90.0 * pi / 180.0);
    CHECK_FALSE(movers[0].is_round);
    CHECK(movers[0].stops == 2);
    CHECK_FALSE(movers[0].runs);
    CHECK(movers[0].period == 2.0);
    CHECK(movers[1].path == std::vector<Vec2>{{}, {0.0, 0.5}});
    CHECK(movers[1].is_steady);
    CHECK(movers[1].period == 0.5);
    CHECK(movers[2].path.size() == 3);
    CHECK(length(movers[2].path[2] - Vec2{0.5, 0.5}) < 1e-15);
    CHECK_FALSE(movers[2].is_round);
    CHECK(movers[2].edges.size() == 4);
    CHECK(movers[3].is_round);
    CHECK(movers[3].path.size() == 4);
    CHECK(movers[3].path.back() == Vec2{});
}

TEST_CASE("motions: edges that move have corners, in curves too") {
    const std::string arc = "arc name=bowl at=0,0 radius=50 from=180 to=360\n";
    CHECK(loaded(arc).world.model().curved);
    CHECK_FALSE(loaded(arc + "motion slide bowl by=0,5 every=3\n").world.model().curved);
}

TEST_CASE("motions: `move` sets their time, and stops and starts them") {
    const std::string lift =
        "edge name=lift 0,0 10,0\nmotion slide lift by=0,5 every=4 time=1 waits\n";
    const Scene moved = loaded(lift + "move lift time=2 runs\n");
    CHECK(moved.world.movers()[0].clock == 2.0);
    CHECK(moved.world.movers()[0].runs);
    CHECK(moved.world.capsules().shape[0].start == Vec2{0.0, 5.0});
    const Scene waiting = loaded(lift + "move lift waits\n");
    CHECK(waiting.world.movers()[0].clock == 1.0);
    CHECK_FALSE(waiting.world.movers()[0].runs);
}

TEST_CASE("motions: nothing is said of gaps at edges that move") {
    const std::string text =
        "carom 1 \"Gap\"\nball a at=0,9 r=1\nedge name=wall 0,0 10,0\nedge name=door 11,0 20,0\n";
    CHECK(load_level(text, "m.level").diagnostics.size() == 1);
    CHECK(load_level(text + "motion swing door about=20,0 by=90 every=4\n", "m.level")
              .diagnostics.empty());
}
