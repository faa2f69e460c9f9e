#include "game/replay/replayer.h"

#include <doctest/doctest.h>

#include "game/support/scenes.h"
#include "level/load.h"
#include "physics/world/fingerprint.h"

using namespace carom;
using carom::test::ball_at_rest;
using carom::test::busy_box;

namespace {

constexpr SolverSettings swept{.kind = SolverKind::swept};

/// 500 ticks, interrupted in the middle of a drag.
Session cut_off() {
    Session session(busy_box(), swept);
    for (int tick = 0; tick < 500; ++tick) {
        const auto apply = [&](const Command& c) { REQUIRE(session.apply(c) == std::nullopt); };
        if (tick == 3) apply(command::Strike{BallId{1}, {-40.0, 21.0}});
        if (tick == 50) apply(command::SetSolver{{.kind = SolverKind::discrete}});
        if (tick == 90) apply(command::AddBall{ball_at_rest({-5.0, -5.0})});
        if (tick > 450) apply(command::HoldBall{BallId{0}, {10.0 + 0.01 * tick, 12.0}});
        session.step_forward();
    }
    return session;
}

Replay written_and_read(const Session& session) {
    const auto read = read_replay(replay_text(record(session, "busy.level", {})));
    REQUIRE(std::holds_alternative<Replay>(read));
    return std::get<Replay>(read);
}

}  // namespace

TEST_CASE("an interrupted session is resumed at the point of interruption, bit by bit") {
    Session original = cut_off();
    Replayer replayer(written_and_read(original), busy_box());
    int slices = 0;
    double progress = 0.0;
    while (replayer.advance(100)) {
        ++slices;
        CHECK(replayer.progress() > progress);
        progress = replayer.progress();
    }
    CHECK(slices == 4);
    CHECK(replayer.progress() == 1.0);
    REQUIRE_FALSE(replayer.failure());
    Session restored = std::move(replayer).take();
    CHECK(fingerprint(restored.world()) == fingerprint(original.world()));
    CHECK(restored.solver() == original.solver());
    CHECK(restored.world().held_balls().size() == 1);
    for (int tick = 0; tick < 100; ++tick) {
        original.step_forward();
        restored.step_forward();
    }
    CHECK(fingerprint(restored.world()) == fingerprint(original.world()));
    REQUIRE(original.go_to(33));
    REQUIRE(restored.go_to(33));
    CHECK(fingerprint(restored.world()) == fingerprint(original.world()));
}

TEST_CASE("the future of a player who has gone back is kept") {
    Session original = cut_off();
    REQUIRE(original.go_to(200));
    Replayer replayer(written_and_read(original), busy_box());
    while (replayer.advance(1000)) {
    }
    REQUIRE_FALSE(replayer.failure());
    Session restored = std::move(replayer).take();
    CHECK(restored.world().tick() == 200);
    CHECK(restored.latest() == 500);
    CHECK(fingerprint(restored.world()) == fingerprint(original.world()));
}

TEST_CASE("a replay that does not match is detected") {
    SUBCASE("another world") {
        Scene other = busy_box();
        other.world.edit_balls().velocity[0].x += 1e-9;
        Replayer replayer(written_and_read(cut_off()), other);
        while (replayer.advance(1000)) {
        }
        CHECK(replayer.failure() == "at tick 0: the fingerprint differs");
    }
    SUBCASE("a changed command: the interval is reported") {
        Replay replay = written_and_read(cut_off());
        for (TimedCommand& timed : replay.commands)
            if (auto* add = std::get_if<command::AddBall>(&timed.command))
                add->spec.position.x -= 1e-9;
        Replayer replayer(replay, busy_box());
        while (replayer.advance(1000)) {
        }
        REQUIRE(replayer.last_equal());
        REQUIRE(replayer.first_different());
        CHECK(replayer.last_equal()->tick == 0);
        CHECK(replayer.first_different()->tick == 120);
    }
    SUBCASE("an invalid command") {
        Replay replay = written_and_read(cut_off());
        std::get<command::Strike>(replay.commands[0].command).ball = BallId{99};
        Replayer replayer(replay, busy_box());
        CHECK_FALSE(replayer.advance(1000));
        CHECK(replayer.failure() == "at tick 3: there is no ball 99");
    }
}

TEST_CASE("a place beyond all that can be pointed at is refused before anything is computed") {
    Session session(busy_box(), swept);
    for (const Vec2 place : {Vec2{7e16, 0.0}, Vec2{0.0, -7e16}}) {
        CHECK(*session.apply(command::HoldBall{BallId{0}, place}) == "the place is too far away");
        CHECK(session.apply(command::PlaceCapsule{CapsuleId{0}, {0.0, 0.0}, place}));
        Replay replay = written_and_read(cut_off());
        replay.commands.back().command = command::HoldBall{BallId{0}, place};
        replay.level_hash = load_level(replay.texts.front(), replay.level).scene->text_hash;
        const auto scene = scene_of(replay);
        REQUIRE(std::holds_alternative<ReplayError>(scene));
        CHECK(std::get<ReplayError>(scene).message ==
              "the command at tick 499 names a place that is too far away");
    }
}

TEST_CASE("a session without commands or ticks is a replay too") {
    Replayer replayer(written_and_read(Session(busy_box(), swept)), busy_box());
    CHECK_FALSE(replayer.advance(1));
    CHECK_FALSE(replayer.failure());
    CHECK(replayer.progress() == 1.0);
}

TEST_CASE("the level in a replay loads without any file, including its includes and overrides") {
    LoadOptions options;
    options.overrides = {"use gravity 0,-3"};
    options.seed = 5;
    options.rate = 250.0;
    options.resolve_include = [](std::string_view from, std::string_view path) {
        const bool is_first = from == "/home/me/levels/a.level";
        return std::optional(
            IncludedFile{(is_first ? "/home/me/levels/" : "/share/") + std::string(path),
                         is_first ? "include \"lib\"\n" : "let R=2\n"});
    };
    const LoadResult loaded = load_level("carom 1 \"A\"\ninclude \"lib\"\nball at=0,0 r=R",
                                         "/home/me/levels/a.level", options);
    REQUIRE(loaded.scene);
    Session session(*loaded.scene, swept);
    const auto read = read_replay(replay_text(record(session, "a.level", options.overrides)));
    REQUIRE(std::holds_alternative<Replay>(read));
    Replay replay = std::get<Replay>(read);
    const auto scene = scene_of(replay);
    REQUIRE(std::holds_alternative<Scene>(scene));
    CHECK(fingerprint(std::get<Scene>(scene).world) == fingerprint(session.world()));
    CHECK(std::get<Scene>(scene).world.rate() == 250.0);
    CHECK(std::get<Scene>(scene).world.seed() == 5);

    const auto refused = [](const Replay& changed) {
        const auto result = scene_of(changed);
        REQUIRE(std::holds_alternative<ReplayError>(result));
        return std::get<ReplayError>(result).message;
    };
    replay.texts[0] += " ";
    CHECK(refused(replay).starts_with("the level in it has been changed: its hash is "));
    replay.texts[0] += "r=-1\nnonsense";
    CHECK(refused(replay).starts_with("the level in it does not load: a.level:3: "));
}
