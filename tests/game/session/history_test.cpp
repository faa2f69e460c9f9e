#include "game/session/history.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "game/support/scenes.h"

using namespace carom;
using carom::test::ball_at_rest;

namespace {

World world_at(std::uint64_t tick, std::size_t balls = 10) {
    World grown;
    grown.edit_definition().kinds = {Kind{}};
    grown.edit_tick() = tick;
    for (std::size_t i = 0; i < balls; ++i)
        add_ball(grown, ball_at_rest({3.0 * static_cast<double>(i), 0.0}));
    const World world = grown;  // a copy has no spare capacity, like a snapshot
    return world;
}

/// The largest distance from a snapshot to the next, in 0..present, as a share of the snapshot's
/// distance from the present.
double worst_gap(const History& history, std::uint64_t present) {
    double worst = 0.0;
    for (std::uint64_t tick = 1; tick < present - 100; ++tick) {
        const Snapshot* found = history.at_or_before(tick);
        const std::uint64_t from = found ? found->world.tick() : 0;
        worst =
            std::max(worst, static_cast<double>(tick - from) / static_cast<double>(present - tick));
    }
    return worst;
}

}  // namespace

TEST_CASE("a history returns the last snapshot at or before a tick") {
    History history(1 << 20);
    for (const std::uint64_t tick : {30u, 10u, 20u})
        history.keep(world_at(tick), {});
    CHECK(history.at_or_before(9) == nullptr);
    CHECK(history.at_or_before(10)->world.tick() == 10);
    CHECK(history.at_or_before(29)->world.tick() == 20);
    CHECK(history.at_or_before(1000)->world.tick() == 30);
}

TEST_CASE("a tick has one snapshot") {
    History history(1 << 20);
    history.keep(world_at(5, 1), {});
    history.keep(world_at(5, 2), {});
    CHECK(history.size() == 1);
    CHECK(history.at_or_before(5)->world.balls().size() == 1);
}

TEST_CASE("dropping snapshots frees their memory") {
    History history(1 << 20);
    for (std::uint64_t tick = 0; tick < 10; ++tick)
        history.keep(world_at(tick), {});
    history.forget_from(8);
    history.forget_before(3);
    CHECK(history.size() == 5);
    CHECK(history.at_or_before(2) == nullptr);
    CHECK(history.at_or_before(100)->world.tick() == 7);
    history.forget_from(0);
    CHECK(history.bytes() == 0);
}

TEST_CASE(
    "memory stays under the limit, and gaps grow in proportion to the distance from the present") {
    const std::size_t one = bytes_of_snapshot(world_at(0));
    for (const std::size_t room : {40u, 100u, 400u}) {
        CAPTURE(room);
        History history(room * one);
        std::uint64_t tick = 0;
        for (; tick < 20000; tick += 4) {
            history.keep(world_at(tick), {});
            REQUIRE(history.bytes() <= room * one);
        }
        CHECK(history.size() > room / 2);
        CHECK(history.at_or_before(tick)->world.tick() == tick - 4);
        // With n snapshots in geometric steps over 20,000 ticks the share is about ln(20000)/n; it
        // is larger where thinning has just freed a quarter of the memory.
        CHECK(worst_gap(history, tick) < 30.0 / static_cast<double>(room));
    }
}

TEST_CASE("a world larger than the limit is not kept") {
    History history(bytes_of_snapshot(world_at(0)) - 1);
    history.keep(world_at(0), {});
    CHECK(history.size() == 0);
    CHECK(history.bytes() == 0);
}

TEST_CASE("a lower limit thins at once") {
    const std::size_t one = bytes_of_snapshot(world_at(0));
    History history(100 * one);
    for (std::uint64_t tick = 0; tick < 100; ++tick)
        history.keep(world_at(tick), {});
    history.set_limit(10 * one, 99);
    CHECK(history.bytes() <= 10 * one);
    CHECK(history.size() >= 3);
    history.set_limit(0, 99);
    CHECK(history.size() == 0);
}
