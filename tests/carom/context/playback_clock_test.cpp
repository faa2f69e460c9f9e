#include "carom/context/playback_clock.h"

#include <doctest/doctest.h>

#include <cmath>

#include "game/support/scenes.h"

using namespace carom;
using carom::test::busy_box;

namespace {

const MayGoOn always = [] { return true; };
const MayGoOn never = [] { return false; };

Session session() {
    return Session(busy_box(), {.kind = SolverKind::swept});
}

}  // namespace

TEST_CASE("the number of ticks depends on the time, not on the frames") {
    for (const int frames : {30, 60, 77, 144, 1000}) {
        CAPTURE(frames);
        Session game = session();
        PlaybackClock clock;
        for (int frame = 0; frame < frames; ++frame)
            clock.advance(game, 1.0 / frames, always);
        CHECK(std::abs(static_cast<double>(game.world().tick()) - 120.0) <= 1.0);
    }
}

TEST_CASE("gears go from a hundredth to a thousandfold") {
    PlaybackClock clock;
    CHECK(clock.speed() == 1.0);
    for (int i = 0; i < 100; ++i)
        clock.slower();
    CHECK(clock.speed() == 0.01);
    for (int i = 0; i < 100; ++i)
        clock.faster();
    CHECK(clock.speed() == 1000.0);
    clock.normal();
    CHECK(clock.speed() == 1.0);
}

TEST_CASE("slow motion computes a tick now and then") {
    Session game = session();
    PlaybackClock clock;
    for (int i = 0; i < 100; ++i)
        clock.slower();
    for (int frame = 0; frame < 600; ++frame)
        clock.advance(game, 1.0 / 60.0, always);
    CHECK(game.world().tick() >= 11);
    CHECK(game.world().tick() <= 12);
}

TEST_CASE("a paused clock computes nothing") {
    Session game = session();
    PlaybackClock clock;
    clock.pause(true);
    CHECK(clock.advance(game, 10.0, always) == 0);
    clock.pause(false);
    CHECK(clock.advance(game, 1.0 / 120.0, always) == 1);
}

TEST_CASE("on a slow machine the game slows down, says so, and does not fall ever further behind") {
    Session game = session();
    PlaybackClock clock;
    for (int frame = 0; frame < 60; ++frame)
        CHECK(clock.advance(game, 1.0 / 60.0, never) == 1);  // at least one: time passes
    CHECK(clock.is_behind());
    CHECK(clock.ticks_per_second() == doctest::Approx(60.0).epsilon(0.05));
    CHECK(clock.advance(game, 1.0 / 60.0, always) <= 3);  // missed ticks are not made up for
    for (int frame = 0; frame < 60; ++frame)
        clock.advance(game, 1.0 / 60.0, always);
    CHECK_FALSE(clock.is_behind());
    CHECK(clock.ticks_per_second() == doctest::Approx(120.0).epsilon(0.05));
}

TEST_CASE("a search ends at a collision and pauses there") {
    Session game = session();
    PlaybackClock clock;
    clock.seek_collision();
    int frames = 0;
    for (; clock.is_seeking() && frames < 10000; ++frames)
        clock.advance(game, 1.0 / 60.0, never);
    CHECK(frames > 1);
    CHECK_FALSE(clock.search_failed());
    CHECK_FALSE(game.contacts().empty());
    CHECK(clock.is_paused());
}

TEST_CASE("a search that finds nothing ends too") {
    Scene empty = busy_box();
    empty.world.edit_balls() = {};
    empty.world.edit_definition().rate = 2.0;
    Session game(empty, {});
    PlaybackClock clock;
    clock.seek_collision();
    clock.advance(game, 1.0, always);
    CHECK_FALSE(clock.is_seeking());
    CHECK(clock.search_failed());
    CHECK(game.world().tick() >= 1200);
    CHECK(game.world().tick() < 1210);
}

TEST_CASE("pausing ends a search") {
    Session game = session();
    PlaybackClock clock;
    clock.seek_collision();
    clock.pause(true);
    CHECK(clock.advance(game, 1.0, always) == 0);
}
