#include "carom/play/comparison_run.h"

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
    Rival rival;

    explicit Pair(const SolverSettings& solver) : rival(session, solver) {}

    bool follow() { return rival.follow(session, {}, {}); }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            session.step_forward();
            follow();
        }
    }
};

}  // namespace

TEST_CASE("a rival under the same solver never parts, commands and all") {
    Pair pair(swept);
    pair.run(50);
    CHECK_FALSE(pair.session.apply(command::AddBall{ball_at_rest({4.0, 26.0})}));
    CHECK_FALSE(pair.session.apply(command::SetGravity{Vec2{0.0, -30.0}}));
    pair.run(100);
    CHECK(pair.rival.world().balls.size() == 10);
    CHECK(is_same_state(pair.rival.world(), pair.session.world()));
    CHECK_FALSE(pair.rival.parting());
}

TEST_CASE("a rival keeps its own solver when the session changes its") {
    Pair pair(swept);
    pair.run(10);
    pair.session.apply(command::SetSolver{discrete});
    pair.run(200);
    CHECK(pair.rival.solver() == swept);
    CHECK(pair.rival.parting());
}

TEST_CASE("the parting is the first tick at which a ball is a hundredth of a radius off") {
    Pair pair(discrete);
    std::uint64_t expected = 0;
    while (expected == 0) {
        pair.run(1);
        const World& a = pair.session.world();
        const World& b = pair.rival.world();
        for (std::size_t i = 0; i < a.balls.size(); ++i)
            if (distance(a.balls.position[i], b.balls.position[i]) > 0.01 * a.balls.radius[i])
                expected = a.tick;
    }
    REQUIRE(pair.rival.parting());
    const Rival::Parting parting = *pair.rival.parting();
    CHECK(parting.tick == expected);
    CHECK(parting.time == pair.session.world().time());
    const auto ball = index_of(pair.session.world(), parting.ball);
    REQUIRE(ball);
    CHECK(parting.place == pair.session.world().balls.position[*ball]);
    pair.run(20);
    CHECK(pair.rival.parting()->tick == expected);
}

TEST_CASE("a rival goes back with the session, to the same bits, and the parting is forgotten") {
    Pair pair(discrete);
    pair.run(37);
    const std::uint64_t before = fingerprint(pair.rival.world());
    pair.run(200);
    REQUIRE(pair.rival.parting());
    const std::uint64_t parted = pair.rival.parting()->tick;
    pair.session.go_to(37);
    CHECK(pair.follow());
    CHECK(fingerprint(pair.rival.world()) == before);
    pair.session.go_to(std::min<std::uint64_t>(parted - 1, 37));
    pair.follow();
    CHECK_FALSE(pair.rival.parting());
    while (pair.session.world().tick < 237)
        pair.run(1);
    CHECK(pair.rival.parting()->tick == parted);
}

TEST_CASE("before its beginning, and after a restart, a rival begins anew") {
    Pair pair(discrete);
    pair.run(30);
    Rival late(pair.session, discrete);
    CHECK(late.start_time() == 0.25);
    pair.session.go_to(12);
    CHECK(late.follow(pair.session, {}, {}));
    CHECK(late.start_time() == 0.1);
    CHECK(is_same_state(late.world(), pair.session.world()));
    pair.session.restart();
    late.follow(pair.session, {}, {});
    CHECK(late.start_time() == 0.0);
}

TEST_CASE("what is done at its beginning is part of the beginning") {
    Pair pair(swept);
    pair.session.apply(command::AddBall{ball_at_rest({4.0, 26.0})});
    pair.follow();
    pair.session.apply(command::SetGravity{Vec2{0.0, -30.0}});
    pair.follow();
    pair.run(60);
    CHECK(is_same_state(pair.rival.world(), pair.session.world()));
}

TEST_CASE("a command about a ball that only the session has is left out") {
    Pair pair(discrete);
    pair.run(200);
    // Free there, but perhaps not here; either way the rival goes on.
    pair.session.apply(command::RemoveBall{BallId{3}});
    pair.run(5);
    CHECK(pair.rival.world().balls.size() == 8);
    CHECK(pair.rival.world().tick == 205);
}

TEST_CASE("a rival that may not go on takes the rest up later") {
    Pair pair(discrete);
    for (int i = 0; i < 10; ++i)
        pair.session.step_forward();
    const auto never = [] { return false; };
    CHECK_FALSE(pair.rival.follow(pair.session, never, {}));
    CHECK(pair.rival.world().tick == 1);
    CHECK(pair.follow());
    CHECK(pair.rival.world().tick == 10);
}
