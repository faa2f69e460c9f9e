#include "goals.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace carom::bench;

namespace {

Result result(std::string name, double seconds, double overlap, double residual) {
    Result made;
    made.contestant.name = std::move(name);
    made.seconds = {seconds};
    made.measured = 1.0;
    made.judged = {{.deepest_overlap = overlap, .residual_speed = residual}};
    return made;
}

// A pile of 2,000 with friction.
SceneResults pile() {
    SceneResults made;
    const auto scenes = bench_scenes(false);
    made.scene = *std::ranges::find(scenes, "pile-friction.level", &BenchScene::level);
    made.balls = 2'000;
    made.results = {result(std::string(chipmunk), 4.0, 0.06, 0.04),
                    result("carom contact", 1.0, 0.02, 6e-5)};
    return made;
}

GoalLine line_of(const SceneResults& scene, const std::string& part) {
    const auto lines = goal_lines({scene}, {});
    const auto found = std::ranges::find_if(
        lines, [&](const GoalLine& line) { return line.what.find(part) != std::string::npos; });
    REQUIRE(found != lines.end());
    return *found;
}

}  // namespace

TEST_CASE("goals: a pile is compared with Box2D 3 in the same run, or with a stored measurement") {
    SceneResults scene = pile();
    CHECK(line_of(scene, "residual").measured == doctest::Approx(6e-5 / 3e-5));
    CHECK(line_of(scene, "residual").verdict() == Verdict::missed);
    CHECK(line_of(scene, "overlap").measured == doctest::Approx(0.02 / 0.058));

    scene.results.push_back(result(std::string(box2d3_wasm), 9.0, 0.08, 8e-5));
    CHECK(line_of(scene, "residual").measured == doctest::Approx(0.75));
    CHECK(line_of(scene, "residual").verdict() == Verdict::target_met);
    CHECK(line_of(scene, "overlap").measured == doctest::Approx(0.25));
    // The time of its node build is not used.
    CHECK(line_of(scene, "time").measured ==
          doctest::Approx(0.25 / scene.scene.box2d3_by_chipmunk));
}
