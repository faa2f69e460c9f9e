#include "carom/context/comparison_run.h"

#include <doctest/doctest.h>

#include "game/support/scenes.h"
#include "physics/world/fingerprint.h"

using namespace carom;
using carom::test::ball_at_rest;
using carom::test::busy_box;

namespace {

constexpr SolverSettings swept{.kind = SolverKind::swept};
constexpr SolverSettings discrete{.kind = SolverKind::discrete};

struct Pair {
    Session session{busy_box(), swept};
    ComparisonRun comparison;

    explicit Pair(const SolverSettings& solver) : comparison(session, solver) {}

    bool follow() { return comparison.follow(session, {}, {}); }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            session.step_forward();
            follow();
        }
    }
};

}  // namespace

TEST_CASE("a comparison run under the session's solver never diverges, whatever the commands") {
    Pair pair(swept);
    pair.run(50);
    CHECK_FALSE(pair.session.apply(command::AddBall{ball_at_rest({4.0, 26.0})}));
    CHECK_FALSE(pair.session.apply(command::SetGravity{Vec2{0.0, -30.0}}));
    pair.run(100);
    CHECK(pair.comparison.world().balls().size() == 10);
    CHECK(is_same_state(pair.comparison.world(), pair.session.world()));
    CHECK_FALSE(pair.comparison.divergence());
}

TEST_CASE("a comparison run keeps its own solver when the session changes its solver") {
    Pair pair(swept);
    pair.run(10);
    pair.session.apply(command::SetSolver{discrete});
    pair.run(200);
    CHECK(pair.comparison.solver() == swept);
    CHECK(pair.comparison.divergence());
}

TEST_CASE("the divergence is the first tick at which a ball is off by a hundredth of a radius") {
    Pair pair(discrete);
    std::uint64_t expected = 0;
    while (expected == 0) {
        pair.run(1);
        const World& a = pair.session.world();
        const World& b = pair.comparison.world();
        for (std::size_t i = 0; i < a.balls().size(); ++i)
            if (distance(a.balls().position[i], b.balls().position[i]) > 0.01 * a.balls().radius[i])
                expected = a.tick();
    }
    REQUIRE(pair.comparison.divergence());
    const ComparisonRun::Divergence divergence = *pair.comparison.divergence();
    CHECK(divergence.tick == expected);
    CHECK(divergence.time == pair.session.world().time());
    const auto ball = index_of(pair.session.world(), divergence.ball);
    REQUIRE(ball);
    CHECK(divergence.place == pair.session.world().balls().position[*ball]);
    pair.run(20);
    CHECK(pair.comparison.divergence()->tick == expected);
}

TEST_CASE(
    "a comparison run goes back with the session, to the same bits, and forgets the divergence") {
    Pair pair(discrete);
    pair.run(37);
    const std::uint64_t before = fingerprint(pair.comparison.world());
    pair.run(200);
    REQUIRE(pair.comparison.divergence());
    const std::uint64_t parted = pair.comparison.divergence()->tick;
    pair.session.go_to(37);
    CHECK(pair.follow());
    CHECK(fingerprint(pair.comparison.world()) == before);
    pair.session.go_to(std::min<std::uint64_t>(parted - 1, 37));
    pair.follow();
    CHECK_FALSE(pair.comparison.divergence());
    while (pair.session.world().tick() < 237)
        pair.run(1);
    CHECK(pair.comparison.divergence()->tick == parted);
}

TEST_CASE("before its start, and after a restart, a comparison run restarts") {
    Pair pair(discrete);
    pair.run(30);
    ComparisonRun late(pair.session, discrete);
    CHECK(late.start_time() == 0.25);
    pair.session.go_to(12);
    CHECK(late.follow(pair.session, {}, {}));
    CHECK(late.start_time() == 0.1);
    CHECK(is_same_state(late.world(), pair.session.world()));
    pair.session.restart();
    late.follow(pair.session, {}, {});
    CHECK(late.start_time() == 0.0);
}

TEST_CASE("commands at the tick of its start belong to the start") {
    Pair pair(swept);
    pair.session.apply(command::AddBall{ball_at_rest({4.0, 26.0})});
    pair.follow();
    pair.session.apply(command::SetGravity{Vec2{0.0, -30.0}});
    pair.follow();
    pair.run(60);
    CHECK(is_same_state(pair.comparison.world(), pair.session.world()));
}

TEST_CASE("a command about a ball that only the session has is skipped") {
    Pair pair(discrete);
    pair.run(200);
    // There is room in the session, but perhaps not here; either way the run continues.
    pair.session.apply(command::RemoveBall{BallId{3}});
    pair.run(5);
    CHECK(pair.comparison.world().balls().size() == 8);
    CHECK(pair.comparison.world().tick() == 205);
}

TEST_CASE("an interrupted comparison run continues with the next call") {
    Pair pair(discrete);
    for (int i = 0; i < 10; ++i)
        pair.session.step_forward();
    const auto never = [] { return false; };
    CHECK_FALSE(pair.comparison.follow(pair.session, never, {}));
    CHECK(pair.comparison.world().tick() == 1);
    CHECK(pair.follow());
    CHECK(pair.comparison.world().tick() == 10);
}
