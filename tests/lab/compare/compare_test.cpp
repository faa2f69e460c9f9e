#include "lab/compare/compare.h"

#include <doctest/doctest.h>

#include <string>

#include "lab/support/load.h"

using namespace carom;
using test::load;

namespace {

const char* const thin_walls =
    "rate 60\n"
    "edge r=0  0,0  20,0  20,20  0,20  close\n"
    "ball slow at=10,3 v=1,2 r=0.5\n"
    "ball fast at=3,10 v=900,0 r=0.5\n";

const char* const crowd =
    "rate 60\n"
    "box 0,0 20,20\n"
    "kind disc r=1\n"
    "fill disc count=20 box=0,0,20,20 speed=10\n";

constexpr SolverSettings swept{.kind = SolverKind::swept};
constexpr SolverSettings discrete{.kind = SolverKind::discrete};

bool always(std::uint64_t, std::uint64_t) {
    return true;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("solvers that agree do not diverge") {
    const Scene scene = load(crowd);
    const Comparison comparison =
        compare(scene, {.first = {swept, 60}, .second = {swept, 60}, .time = 1.0}, always);
    CHECK_FALSE(comparison.divergence.has_value());
    CHECK_FALSE(comparison.contact.has_value());
    CHECK_FALSE(comparison.growth.has_value());
    CHECK_FALSE(comparison.is_lost);
    CHECK(comparison.differences.size() == 61);
    CHECK(comparison.time() == doctest::Approx(1.0));
    const std::string text = compare_text(scene, comparison);
    CHECK(has(text, "They do not part within 1 s"));
    CHECK(has(text, "Every ball meets the same others in the same order."));
    CHECK(has(compare_json("crowd", scene, comparison), "\"parting\": null"));
}

TEST_CASE("a ball that passes through a wall diverges there, and the missing contact is named") {
    const Scene scene = load(thin_walls);
    const Comparison comparison =
        compare(scene, {.first = {swept, 60}, .second = {discrete, 60}, .time = 1.0}, always);
    REQUIRE(comparison.divergence.has_value());
    CHECK(comparison.divergence->ball == BallId{1});
    CHECK(comparison.divergence->time == doctest::Approx(2.0 / 60.0));
    CHECK(comparison.is_lost);
    CHECK(comparison.time() < 0.5);
    REQUIRE(comparison.contact.has_value());
    CHECK(comparison.contact->ball == 1);
    REQUIRE(comparison.contact->first.has_value());
    CHECK(comparison.contact->first->kind == ContactKind::ball_edge);
    CHECK(comparison.contact->time == doctest::Approx(16.5 / 900.0));
    const std::string text = compare_text(scene, comparison);
    CHECK(has(text, "They part after 0.0333333 s: ball 1 (fast) is "));
    CHECK(has(text, "The first contact that differs is of ball 1 (fast):"));
    CHECK(has(text, "under swept at 60 ticks a second: meets edge "));
    CHECK(has(text, "under discrete at 60 ticks a second: meets nothing any more"));
}

TEST_CASE("different rates are compared at their common instants") {
    const Comparison comparison =
        compare(load(crowd), {.first = {swept, 60}, .second = {swept, 90}, .time = 0.5}, always);
    CHECK(comparison.differences.size() == 16);
    CHECK(comparison.differences[1].time == doctest::Approx(1.0 / 30.0));
    CHECK(comparison.differences[1].max < 1e-9);
}

TEST_CASE("a perturbed crowd diverges exponentially") {
    const Scene scene = load(crowd);
    const Comparison comparison = compare(
        scene, {.first = {swept, 60}, .second = {swept, 60}, .time = 60.0, .nudge = 1e-9}, always);
    CHECK(comparison.differences.front().max <= 1.5e-9);
    CHECK(comparison.differences.front().max > 0.0);
    REQUIRE(comparison.divergence.has_value());
    REQUIRE(comparison.growth.has_value());
    CHECK(comparison.growth->doubling_time > 0.0);
    CHECK(comparison.growth->doubling_time < comparison.time() / 20.0);
    const std::string json = compare_json("crowd", scene, comparison);
    CHECK(has(json, "\"doubling_time\": "));
    CHECK(has(json, "\"first\": {\"solver\": \"swept\", \"settings\": {\"substeps\": 1}"));
    CHECK(has(compare_text(scene, comparison), "The difference doubles every "));
}

TEST_CASE("an interrupt ends the comparison at once") {
    const Comparison comparison =
        compare(load(crowd), {.first = {swept, 60}, .second = {swept, 60}, .time = 1.0},
                [](std::uint64_t done, std::uint64_t) { return done < 7; });
    CHECK(comparison.is_interrupted);
    CHECK(comparison.differences.size() == 7);
}
