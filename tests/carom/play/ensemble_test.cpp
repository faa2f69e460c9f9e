#include "carom/play/ensemble.h"

#include <doctest/doctest.h>

#include "carom/play/comparison_run.h"
#include "game/support/scenes.h"

using namespace carom;
using carom::test::busy_box;

namespace {

constexpr SolverSettings swept{.kind = SolverKind::swept};

}  // namespace

TEST_CASE("the swarm follows the session, whose game its first copy is") {
    Session session(busy_box(), swept);
    Swarm swarm(session);
    CHECK(swarm.copies().size() == 200);
    CHECK(swarm.spread() > 0.0);
    CHECK(swarm.spread() < 1e-8);
    for (int i = 0; i < 60; ++i)
        session.step_forward();
    CHECK(swarm.is_behind(session));
    CHECK(swarm.follow(session, {}, {}));
    CHECK_FALSE(swarm.is_behind(session));
    session.apply(command::SetGravity{Vec2{0.0, -30.0}});
    session.apply(command::SetSolver{{.kind = SolverKind::substep}});
    for (int i = 0; i < 60; ++i)
        session.step_forward();
    swarm.follow(session, {}, {});
    CHECK(is_same_state(swarm.copies().front(), session.world()));
}

TEST_CASE("a swarm spreads to a radius, once") {
    Session session(busy_box(), swept);
    Swarm swarm(session);
    while (!swarm.time_of_a_radius() && session.world().tick < 6000) {
        session.step_forward();
        swarm.follow(session, {}, {});
        CHECK((swarm.spread() >= 1.0) == swarm.time_of_a_radius().has_value());
    }
    REQUIRE(swarm.time_of_a_radius());
    CHECK(*swarm.time_of_a_radius() == session.world().time());
    const double time = *swarm.time_of_a_radius();
    session.step_forward();
    swarm.follow(session, {}, {});
    CHECK(*swarm.time_of_a_radius() == time);
}

TEST_CASE("when the session goes back, the swarm begins anew there") {
    Session session(busy_box(), swept);
    Swarm swarm(session);
    for (int i = 0; i < 100; ++i)
        session.step_forward();
    swarm.follow(session, {}, {});
    session.step_back();
    CHECK(swarm.follow(session, {}, {}));
    CHECK(swarm.start_time() == session.world().time());
    CHECK(swarm.spread() < 1e-8);
}

TEST_CASE("a swarm that is interrupted between its copies comes to the same") {
    Session session(busy_box(), swept);
    Swarm at_once(session);
    Swarm in_bits(session);
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
