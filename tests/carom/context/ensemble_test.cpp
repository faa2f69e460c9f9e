#include "carom/context/ensemble.h"

#include <doctest/doctest.h>

#include "carom/context/comparison_run.h"
#include "game/support/scenes.h"

using namespace carom;
using carom::test::busy_box;

namespace {

constexpr SolverSettings swept{.kind = SolverKind::swept};

}  // namespace

TEST_CASE("an ensemble follows the session, and its first copy is the session's game") {
    Session session(busy_box(), swept);
    Ensemble ensemble(session);
    CHECK(ensemble.copies().size() == 200);
    CHECK(ensemble.spread() > 0.0);
    CHECK(ensemble.spread() < 1e-8);
    for (int i = 0; i < 60; ++i)
        session.step_forward();
    CHECK(ensemble.is_behind(session));
    CHECK(ensemble.follow(session, {}, {}));
    CHECK_FALSE(ensemble.is_behind(session));
    session.apply(command::SetGravity{Vec2{0.0, -30.0}});
    session.apply(command::SetSolver{{.kind = SolverKind::substep}});
    for (int i = 0; i < 60; ++i)
        session.step_forward();
    ensemble.follow(session, {}, {});
    CHECK(is_same_state(ensemble.copies().front(), session.world()));
}

TEST_CASE("an ensemble reports once when its spread reaches a radius") {
    Session session(busy_box(), swept);
    Ensemble ensemble(session);
    while (!ensemble.time_of_a_radius() && session.world().tick() < 6000) {
        session.step_forward();
        ensemble.follow(session, {}, {});
        CHECK((ensemble.spread() >= 1.0) == ensemble.time_of_a_radius().has_value());
    }
    REQUIRE(ensemble.time_of_a_radius());
    CHECK(*ensemble.time_of_a_radius() == session.world().time());
    const double time = *ensemble.time_of_a_radius();
    session.step_forward();
    ensemble.follow(session, {}, {});
    CHECK(*ensemble.time_of_a_radius() == time);
}

TEST_CASE("when the session goes back, the ensemble restarts there") {
    Session session(busy_box(), swept);
    Ensemble ensemble(session);
    for (int i = 0; i < 100; ++i)
        session.step_forward();
    ensemble.follow(session, {}, {});
    session.step_back();
    CHECK(ensemble.follow(session, {}, {}));
    CHECK(ensemble.start_time() == session.world().time());
    CHECK(ensemble.spread() < 1e-8);
}

TEST_CASE("an ensemble interrupted between copies computes the same bits") {
    Session session(busy_box(), swept);
    Ensemble at_once(session);
    Ensemble in_bits(session);
    for (int i = 0; i < 5; ++i)
        session.step_forward();
    at_once.follow(session, {}, {});
    int calls = 0;
    int asked = 0;
    while (!in_bits.follow(session, [&] { return ++asked % 7 != 0; }, {}))
        ++calls;
    CHECK(calls > 100);
    for (std::size_t i = 0; i < at_once.copies().size(); ++i)
        CHECK(is_same_state(at_once.copies()[i], in_bits.copies()[i]));
}
