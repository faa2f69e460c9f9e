#include "lab/run/judge.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

#include "lab/run/run_record.h"
#include "level/load.h"

using namespace carom;

namespace {

Scene load(const std::string& statements, const LoadOptions& options = {}) {
    LoadResult result = load_level("carom 1 \"test\"\n" + statements, "test.level", options);
    for (const Diagnostic& diagnostic : result.diagnostics)
        MESSAGE(render(diagnostic));
    REQUIRE(result.scene.has_value());
    return *result.scene;
}

RunRecord run(const Scene& scene, std::uint64_t ticks) {
    World world = scene.world;
    Solver solver(solver_for(scene));
    RunRecord record = begin_record(scene, solver.settings());
    while (world.tick() < ticks) {
        solver.tick(world);
        note_tick(record, scene, world, solver);
    }
    note_end(record, scene, world);
    return record;
}

RunWatch watch_of(const Scene& scene) {
    return {scene, RunWatch::Conservation::ignored};
}

Quantity of_bins(QuantityKind kind, std::vector<double> expected) {
    Quantity quantity;
    quantity.kind = kind;
    quantity.counters = {0, 1, 2};
    quantity.expected = std::move(expected);
    return quantity;
}

}  // namespace

TEST_CASE("quantities of the world") {
    const Scene scene =
        load("use gravity 0,-2\nball a at=3,4 v=3,4 m=2\nball b at=10,4 v=-1,0 m=1\n");
    struct Row {
        QuantityKind kind;
        double value;
    };
    const Row rows[] = {
        {quantity_named("collisions"), 0},
        {quantity_named("kinetic_energy"), 25.5},
        {quantity_named("potential_energy"), 24},
        {quantity_named("energy"), 49.5},
        {quantity_named("momentum_x"), 5},
        {quantity_named("momentum_y"), 8},
        {quantity_named("time"), 0},
        {quantity_named("balls"), 2},
        {quantity_named("removed"), 0},
        {quantity_named("x"), 3},
        {quantity_named("y"), 4},
        {quantity_named("vx"), 3},
        {quantity_named("vy"), 4},
        {quantity_named("speed"), 5},
    };
    for (const Row& row : rows) {
        CAPTURE(name(row.kind));
        Quantity quantity;
        quantity.kind = row.kind;
        quantity.ball = scene.world.balls().id[0];
        CHECK(measure(quantity, scene.world, nullptr) == row.value);
    }
}

TEST_CASE("a removed ball has no position") {
    Scene scene = load("ball a at=3,4\nball b at=9,9\n");
    Quantity quantity;
    quantity.kind = quantity_named("x");
    quantity.ball = scene.world.balls().id[0];
    remove_ball(scene.world, quantity.ball);
    CHECK_FALSE(measure(quantity, scene.world, nullptr).has_value());
    const Expect expect{.quantity = "a.x", .what = quantity, .value = 3.0, .tolerance = 1e9};
    Judgement judgement;
    judge(expect, scene.world, watch_of(scene), true, judgement);
    CHECK(judgement.verdict == Verdict::fails);
}

TEST_CASE("quantities of bins") {
    World world;
    world.edit_ledger().counters = {1, 2, 1};
    const std::vector<double> fair{0.25, 0.5, 0.25};
    CHECK(measure(of_bins(quantity_named("count"), fair), world, nullptr) == 4.0);
    CHECK(measure(of_bins(quantity_named("mean"), fair), world, nullptr) == 1.0);
    CHECK(measure(of_bins(quantity_named("variance"), fair), world, nullptr) == 0.5);
    CHECK(measure(of_bins(quantity_named("variance_ratio"), fair), world, nullptr) == 1.0);
    CHECK(measure(of_bins(quantity_named("chi_square"), fair), world, nullptr) == 0.0);

    world.edit_ledger().counters = {4, 0, 0};
    CHECK(measure(of_bins(quantity_named("mean"), fair), world, nullptr) == 0.0);
    CHECK(measure(of_bins(quantity_named("variance"), fair), world, nullptr) == 0.0);
    // (4-1)^2/1 + (0-2)^2/2 + (0-1)^2/1
    CHECK(measure(of_bins(quantity_named("chi_square"), fair), world, nullptr) == 12.0);
    CHECK(measure(of_bins(quantity_named("chi_square"), {1, 0, 0}), world, nullptr) == 0.0);
    CHECK(measure(of_bins(quantity_named("chi_square"), {0, 0.5, 0.5}), world, nullptr) ==
          std::numeric_limits<double>::infinity());
    CHECK_FALSE(
        measure(of_bins(quantity_named("variance_ratio"), {1, 0, 0}), world, nullptr).has_value());

    world.edit_ledger().counters = {0, 0, 0};
    CHECK(measure(of_bins(quantity_named("count"), fair), world, nullptr) == 0.0);
    CHECK_FALSE(measure(of_bins(quantity_named("mean"), fair), world, nullptr).has_value());
    CHECK_FALSE(measure(of_bins(quantity_named("chi_square"), fair), world, nullptr).has_value());
}

TEST_CASE("an expectation is judged at its time, or else at the end") {
    const Scene scene = load(
        "ball a at=0,0 v=12,0\n"
        "expect a.x 6 within 1e-9 at=0.5\n"
        "expect a.x 12 within 1e-9\n"
        "expect a.x 7 within 0.5 at=0.5\n"
        "expect a.x 0 within 0 at=0\n"
        "expect a.x 24 within 1e-9 at=2\n");
    const RunRecord record = run(scene, 120);
    REQUIRE(record.judgements.size() == 5);
    CHECK(record.judgements[0].verdict == Verdict::holds);
    CHECK(record.judgements[1].verdict == Verdict::holds);
    CHECK(record.judgements[2].verdict == Verdict::fails);
    CHECK(*record.judgements[2].measured == doctest::Approx(6.0).epsilon(1e-9));
    CHECK(record.judgements[3].verdict == Verdict::holds);
    CHECK(record.judgements[4].verdict == Verdict::not_judged);
    CHECK(has_failure(record));
}

TEST_CASE("an expectation compares, at a time, by a time, always and never") {
    const Scene scene = load(
        "ball a at=0,0 v=12,0\n"
        "expect a.x < 6.1 at=0.5\n"   // 6
        "expect a.x <= 5.9 at=0.5\n"  // fails
        "expect a.x > 11.9\n"         // at the end, 12
        "expect a.x > 5 by=0.5\n"     // at some tick
        "expect a.x >= 7 by=0.5\n"    // fails: 6 at most
        "expect a.x > 20 by=5s\n"     // not judged
        "expect a.x < 12.5 always\n"  // holds
        "expect a.x < 6 always\n"     // fails at 0.5
        "expect a.x < 6.05 always by=0.5\n"
        "expect a.x > 12.5 never\n"
        "expect a.x 6 within 0.01 never\n"  // fails at 0.5
        "expect a.x 3 within 0.01 by=0.5\n"
        "expect a.x < 5 always by=3s\n");  // fails before its time
    const RunRecord record = run(scene, 120);
    using enum Verdict;
    const std::vector<Verdict> verdicts{holds, fails, holds, holds, fails, not_judged, holds,
                                        fails, holds, holds, fails, holds, fails};
    REQUIRE(record.judgements.size() == verdicts.size());
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        CAPTURE(i);
        CHECK(record.judgements[i].verdict == verdicts[i]);
    }
    CHECK(*record.judgements[7].time == doctest::Approx(0.5));
    CHECK(*record.judgements[10].time == doctest::Approx(0.5));
}

// The mean of empty bins has no value; a ball that was removed has no place.
TEST_CASE("ticks without a value count for nothing, but there must be one with a value") {
    const Scene scene = load(
        "ball a at=0,0 v=12,0\n"
        "bins at=0,-20 count=2 width=1 depth=1 open\n"
        "zone gone 9,-1 9,1 r=1 sink\n"
        "expect a.x < 12 always\n"
        "expect a.x > 8 by=1s\n"
        "expect mean(bins) < 5 always\n"
        "expect a.x < 12\n");
    const RunRecord record = run(scene, 120);
    CHECK(record.judgements[0].verdict == Verdict::holds);
    CHECK(record.judgements[1].verdict == Verdict::fails);  // it is taken at 8
    CHECK(record.judgements[2].verdict == Verdict::fails);  // never any value
    CHECK(record.judgements[3].verdict == Verdict::fails);  // gone at the end
}

TEST_CASE("nothing is judged if options changed the level") {
    const Scene scene =
        load("ball a at=0,0 v=12,0\nexpect a.x 99 within 1 at=0.5\nexpect a.x 99 within 1\n",
             {.rate = 60.0});
    const RunRecord record = run(scene, 60);
    REQUIRE(record.judgements.size() == 2);
    CHECK(record.judgements[0].verdict == Verdict::not_judged);
    CHECK(record.judgements[1].verdict == Verdict::not_judged);
    CHECK_FALSE(has_failure(record));
}

TEST_CASE("every quantity that a level can expect is computed") {
    const Scene scene = load("ball a at=3,4 v=1,0\nuse spin\n");
    const RunWatch watch = watch_of(scene);
    World world = scene.world;
    world.edit_ledger().counters = {1, 2, 1};
    for (const QuantityRow& row : quantities()) {
        CAPTURE(row.name);
        if (row.observable) continue;  // tests/lab/observe
        Quantity quantity = of_bins(&row, {0.25, 0.5, 0.25});
        quantity.ball = world.balls().id[0];
        CHECK(measure(quantity, world, &watch).has_value());
        const bool needs_watch = row.scope == QuantityScope::run;
        CHECK(measure(quantity, world, nullptr).has_value() != needs_watch);
    }
}
