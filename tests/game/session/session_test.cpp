#include "game/session/session.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "game/support/scenes.h"
#include "physics/world/fingerprint.h"

using namespace carom;
using carom::test::ball_at_rest;
using carom::test::busy_box;
using carom::test::rainy_torus;

namespace {

constexpr SolverSettings swept{.kind = SolverKind::swept};
constexpr SolverSettings discrete{.kind = SolverKind::discrete};

Command hold(std::uint32_t ball, Vec2 target) {
    return command::HoldBall{BallId{ball}, target};
}

Command drop(std::uint32_t ball) {
    return command::DropBall{BallId{ball}};
}

/// Simulates 600 ticks with all kinds of commands; element t is the fingerprint after tick t and
/// all commands of that tick.
std::vector<std::uint64_t> play_busily(Session& session) {
    std::vector<std::uint64_t> fingerprints;
    for (int tick = 0; tick <= 600; ++tick) {
        const auto apply = [&](const Command& c) { REQUIRE(session.apply(c) == std::nullopt); };
        if (tick == 0) apply(command::Strike{BallId{4}, {55.0, 13.0}});
        if (tick >= 40 && tick < 80) apply(hold(2, {20.0 + 0.1 * tick, 12.0}));
        if (tick == 80) apply(drop(2));
        if (tick == 100) apply(command::SetGravity{Vec2{0.0, -9.0}});
        if (tick == 120) apply(command::SetSolver{discrete});
        if (tick == 200) apply(command::RemoveBall{BallId{3}});
        if (tick >= 210 && tick < 260)
            apply(command::HoldCapsule{session.world().capsules().id.back(),
                                       {30.0, 20.0 - 0.05 * (tick - 210)},
                                       {36, 25}});
        if (tick == 260) apply(command::DropCapsule{session.world().capsules().id.back()});
        if (tick == 300) apply(command::SetGravity{});
        if (tick == 310) apply(command::SetSolver{swept});
        fingerprints.push_back(fingerprint(session.world()));
        if (tick < 600) session.step_forward();
    }
    return fingerprints;
}

}  // namespace

TEST_CASE("going back, forward and anywhere gives the same bits") {
    for (const Scene& scene : {busy_box(), rainy_torus()}) {
        // From memory for everything to memory for a handful of snapshots.
        for (const std::size_t memory :
             {std::size_t{64} << 20, std::size_t{100000}, std::size_t{40000}}) {
            CAPTURE(memory);
            Session session(scene, swept, memory);
            const auto expected = play_busily(session);
            for (int tick = 600; tick >= 0; --tick) {
                REQUIRE(session.go_to(static_cast<std::uint64_t>(tick)));
                REQUIRE(fingerprint(session.world()) == expected[static_cast<std::size_t>(tick)]);
            }
            REQUIRE(session.go_to(0));
            for (std::size_t tick = 1; tick <= 600; ++tick) {
                session.step_forward();
                REQUIRE(fingerprint(session.world()) == expected[tick]);
            }
            for (const std::uint64_t tick : {300u, 7u, 599u, 0u, 211u, 121u, 120u, 600u, 5u}) {
                REQUIRE(session.go_to(tick));
                CHECK(fingerprint(session.world()) == expected[tick]);
                CHECK(session.world().tick() == tick);
            }
            CHECK(session.latest() == 600);
        }
    }
}

TEST_CASE("stepping back gives the contacts of that tick too") {
    Session session(busy_box(), swept);
    std::vector<std::vector<double>> impulses;
    const auto now = [&] {
        std::vector<double> all;
        for (const Contact& contact : session.contacts())
            all.push_back(contact.impulse);
        return all;
    };
    std::size_t count = 0;
    for (int tick = 0; tick < 300; ++tick) {
        impulses.push_back(now());
        count += impulses.back().size();
        session.step_forward();
    }
    REQUIRE(count > 10);
    for (std::size_t tick = 300; tick-- > 0;) {
        REQUIRE(session.step_back());
        REQUIRE(now() == impulses[tick]);
    }
    CHECK_FALSE(session.step_back());
}

TEST_CASE("a command in the past makes another future") {
    Session session(busy_box(), swept);
    play_busily(session);
    REQUIRE(session.go_to(150));
    REQUIRE(session.apply(command::Strike{BallId{0}, {1.0, 2.0}}) == std::nullopt);
    CHECK(session.latest() == 150);
    CHECK(session.commands().back().tick == 150);
    CHECK_FALSE(session.go_to(151));
    std::vector<std::uint64_t> fingerprints;
    for (int tick = 150; tick < 400; ++tick) {
        fingerprints.push_back(fingerprint(session.world()));
        session.step_forward();
    }
    for (std::size_t tick = 400; tick-- > 150;) {
        REQUIRE(session.step_back());
        REQUIRE(fingerprint(session.world()) == fingerprints[tick - 150]);
    }
}

TEST_CASE("an object held in a forgotten future is dropped") {
    Session session(busy_box(), swept);
    play_busily(session);
    REQUIRE(session.go_to(60));
    REQUIRE(session.world().held_balls().size() == 1);
    REQUIRE(session.apply(command::Strike{BallId{0}, {1.0, 2.0}}) == std::nullopt);
    CHECK(session.world().held_balls().empty());
    session.step_forward();
    CHECK(session.world().held_balls().empty());
}

TEST_CASE("undo reverts one gesture at a time") {
    Session session(busy_box(), swept);
    const auto start = fingerprint(session.world());
    REQUIRE(session.apply(command::AddBall{ball_at_rest({3.0, 26.0})}) == std::nullopt);
    const auto with_ball = fingerprint(session.world());
    for (int tick = 0; tick < 20; ++tick) {
        REQUIRE(session.apply(hold(9, {4.0, 25.0})) == std::nullopt);
        session.step_forward();
    }
    REQUIRE(session.apply(drop(9)) == std::nullopt);
    REQUIRE(session.apply(command::RemoveBall{BallId{1}}) == std::nullopt);
    CHECK(session.undo());
    CHECK(session.world().balls().size() == 10);
    CHECK(session.world().tick() == 20);
    CHECK(session.undo());
    CHECK(session.world().tick() == 0);
    CHECK(fingerprint(session.world()) == with_ball);
    CHECK(session.undo());
    CHECK(fingerprint(session.world()) == start);
    CHECK_FALSE(session.undo());
}

TEST_CASE("two drags are two gestures") {
    Session session(busy_box(), swept);
    for (int drag = 0; drag < 2; ++drag) {
        REQUIRE(session.apply(hold(0, {4.0, 4.0})) == std::nullopt);
        session.step_forward();
        REQUIRE(session.apply(drop(0)) == std::nullopt);
    }
    CHECK(session.undo());
    CHECK(session.world().tick() == 1);
    CHECK(session.commands().size() == 2);
}

TEST_CASE("among many moves of one object in one tick, the last counts") {
    Session session(busy_box(), swept);
    for (int i = 0; i < 100; ++i) {
        for (const std::uint32_t edge : {5u, 6u})
            REQUIRE(session.apply(command::HoldCapsule{
                        CapsuleId{edge}, {30.0, 20.0 + 0.01 * i}, {31.0, 21.0}}) == std::nullopt);
    }
    CHECK(session.commands().size() == 2);
    REQUIRE(session.world().held_capsules().size() == 2);
    CHECK(session.world().held_capsules()[0].start_target.y == doctest::Approx(20.99));
}

TEST_CASE("memory stays within its limit") {
    const std::size_t memory = 200000;
    Session session(busy_box(), swept, memory);
    for (int tick = 0; tick < 5000; ++tick) {
        if (tick % 7 == 0)
            REQUIRE(session.apply(hold(1, {20.0 + tick % 11, 15.0})) == std::nullopt);
        session.step_forward();
        REQUIRE(session.rewind_bytes_used() <= memory);
        if (tick % 1000 == 999) {
            for (int back = 0; back < 300; ++back) {
                REQUIRE(session.step_back());
                REQUIRE(session.rewind_bytes_used() <= memory);
            }
            REQUIRE(session.go_to(session.latest()));
        }
    }
    CHECK(session.snapshot_count() > 10);
}

TEST_CASE("a log that outgrows its memory moves earliest(), and reports it") {
    Session session(busy_box(), swept, 60000);
    std::vector<std::uint64_t> fingerprints{fingerprint(session.world())};
    for (int tick = 0; tick < 1000; ++tick) {
        REQUIRE(session.apply(hold(1, {20.0 + tick % 11, 15.0})) == std::nullopt);
        fingerprints.back() = fingerprint(session.world());
        session.step_forward();
        fingerprints.push_back(fingerprint(session.world()));
        REQUIRE(session.rewind_bytes_used() <= 60000);
    }
    CHECK(session.earliest() > 0);
    CHECK(session.earliest() < 1000);
    CHECK_FALSE(session.is_complete());
    CHECK_FALSE(session.go_to(session.earliest() - 1));
    while (session.step_back())
        REQUIRE(fingerprint(session.world()) == fingerprints[session.world().tick()]);
    CHECK(session.world().tick() == session.earliest());
    session.restart();
    CHECK(session.is_complete());
    CHECK(session.world().tick() == 0);
}

TEST_CASE("restart forgets the commands and keeps the solver") {
    Session session(busy_box(), swept);
    const auto start = fingerprint(session.world());
    play_busily(session);
    REQUIRE(session.apply(command::SetSolver{discrete}) == std::nullopt);
    session.restart();
    CHECK(fingerprint(session.world()) == start);
    CHECK(session.commands().empty());
    CHECK(session.latest() == 0);
    CHECK(session.solver().kind == SolverKind::discrete);
    session.step_forward();
    session.step_back();
    CHECK(session.solver().kind == SolverKind::discrete);
}

TEST_CASE("the next collision is one of a pair that did not touch before") {
    Session session(busy_box(), swept);
    REQUIRE(session.step_to_collision(10000));
    CHECK_FALSE(session.contacts().empty());
    const auto first = session.world().tick();
    REQUIRE(session.step_to_collision(10000));
    CHECK(session.world().tick() > first);
}

TEST_CASE("the search for a collision is bounded") {
    Scene scene = busy_box();
    scene.world.edit_balls() = {};
    Session session(scene, swept);
    CHECK_FALSE(session.step_to_collision(100));
    CHECK(session.world().tick() == 100);
}

TEST_CASE(
    "a session marks its fingerprint once a simulated second, after the commands of that tick") {
    Session session(busy_box(), swept);
    const std::vector<std::uint64_t> fingerprints = play_busily(session);
    const auto check_marks = [&](std::size_t count) {
        REQUIRE(session.fingerprints().marks().size() == count);
        for (std::size_t i = 0; i < count; ++i) {
            CHECK(session.fingerprints().marks()[i].tick == 120 * i);
            CHECK(session.fingerprints().marks()[i].fingerprint == fingerprints[120 * i]);
        }
    };
    // A mark is made only when the next tick starts: until then more commands may come.
    check_marks((session.latest() + 119) / 120);
    SUBCASE("going back and forward changes no mark") {
        REQUIRE(session.go_to(100));
        REQUIRE(session.go_to(600));
        check_marks((session.latest() + 119) / 120);
    }
    SUBCASE("another future drops the marks that it invalidates") {
        REQUIRE(session.go_to(240));
        REQUIRE_FALSE(session.apply(command::SetGravity{Vec2{0.0, 3.0}}));
        check_marks(2);
        session.step_forward();
        REQUIRE(session.fingerprints().marks().size() == 3);
        CHECK(session.fingerprints().marks()[2].fingerprint != fingerprints[240]);
    }
    SUBCASE("undo and restart drop marks too") {
        REQUIRE(session.undo());
        for (const FingerprintMark& mark : session.fingerprints().marks())
            CHECK(mark.tick < session.world().tick());
        session.restart();
        CHECK(session.fingerprints().marks().empty());
    }
}

TEST_CASE("a followed session repeats its recording, goes no further, and refuses commands") {
    Session original(busy_box(), swept);
    const std::vector<std::uint64_t> fingerprints = play_busily(original);
    Session session(busy_box(), swept);
    session.follow({original.commands().begin(), original.commands().end()}, 600);
    CHECK(session.apply(hold(1, {9.0, 9.0})));
    CHECK(fingerprint(session.world()) == fingerprints[0]);
    while (session.step_forward())
        REQUIRE(fingerprint(session.world()) == fingerprints[session.world().tick()]);
    CHECK(session.world().tick() == 600);
    CHECK(session.is_at_end());
    CHECK_FALSE(session.step_to_collision(1000));
    REQUIRE(session.go_to(333));
    CHECK(fingerprint(session.world()) == fingerprints[333]);
    CHECK_FALSE(session.fault());
    session.stop_following();
    CHECK_FALSE(session.apply(command::SetGravity{}));
    CHECK(session.latest() == 333);
}

TEST_CASE("a command that cannot be executed ends the recording there, with the reason") {
    Session session(busy_box(), swept);
    session.follow({{5, command::Strike{BallId{99}, {1.0, 1.0}}}}, 100);
    while (session.step_forward()) {
    }
    CHECK(session.world().tick() == 5);
    CHECK(session.fault() == "at tick 5: there is no ball 99");
}

TEST_CASE("all commands are kept on request, whatever memory they take") {
    Session session(busy_box(), swept, 1 << 16);
    session.keep_all_commands();
    for (int tick = 0; tick < 2000; ++tick) {
        REQUIRE_FALSE(session.apply(hold(1, {10.0 + 0.001 * tick, 12.0})));
        session.step_forward();
    }
    CHECK(session.is_complete());
    CHECK(session.commands().size() == 2000);
}

// Regression: of the placements in one tick only the last of each ball was kept, in the position of
// its first. Then a ball was placed where another still was, and the session could not be resumed.
TEST_CASE("balls that exchange places in a pause can be placed again in the order of the log") {
    Session session(busy_box(), swept);
    const Vec2 one = session.world().balls().position[0];
    const Vec2 two = session.world().balls().position[1];
    REQUIRE_FALSE(session.apply(command::PlaceBall{BallId{0}, {-20.0, -20.0}}));
    REQUIRE_FALSE(session.apply(command::PlaceBall{BallId{1}, one}));
    REQUIRE_FALSE(session.apply(command::PlaceBall{BallId{0}, two}));
    Session again(busy_box(), swept);
    again.follow({session.commands().begin(), session.commands().end()}, 0);
    CHECK_FALSE(again.fault());
    CHECK(fingerprint(again.world()) == fingerprint(session.world()));
}

TEST_CASE("a cancelled long tick has no effect, and can be started again") {
    Scene scene = busy_box();
    scene.world.edit_definition().rate = 1.0;
    for (Vec2& velocity : scene.world.edit_balls().velocity)
        velocity *= 200.0;
    const SolverSettings event{.kind = SolverKind::event};
    Session session(scene, event);
    const std::uint64_t start = fingerprint(session.world());
    int asked = 0;
    session.set_keep_going([&] {
        ++asked;
        return false;
    });
    CHECK_FALSE(session.step_forward());
    CHECK(asked == 1);
    CHECK(session.outcome() == TickOutcome::cancelled);
    CHECK(fingerprint(session.world()) == start);
    CHECK(session.latest() == 0);
    CHECK_FALSE(session.step_to_collision(10));

    Session patient(scene, event);
    session.set_keep_going({});
    for (int i = 0; i < 3; ++i) {
        CHECK(session.step_forward());
        CHECK(patient.step_forward());
    }
    CHECK(session.outcome() == TickOutcome::done);
    CHECK(fingerprint(session.world()) == fingerprint(patient.world()));

    // This holds for rewinding too: the present is then before the requested tick.
    session.set_keep_going([] { return false; });
    CHECK_FALSE(session.go_to(2));
    CHECK(session.world().tick() < 2);
    session.set_keep_going({});
    CHECK(session.go_to(3));
    CHECK(fingerprint(session.world()) == fingerprint(patient.world()));
}
