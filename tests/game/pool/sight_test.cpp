#include "game/pool/sight.h"

#include <doctest/doctest.h>

#include "game/pool/table_places.h"
#include "game/referees/snooker.h"
#include "game/support/table_in_play.h"

using namespace carom;
using namespace carom::snooker;

namespace {

// A table with the cue ball on the left, one red on the right, and the colours out of the way.
struct Sight {
    Sight() : table("snooker") {
        for (int ball = 2; ball <= red_count; ++ball) {
            auto& slot = table.play.balls[static_cast<std::size_t>(ball)];
            remove_ball(table.world, *slot);
            slot.reset();
            table.play.rules.down |= std::uint32_t{1} << ball;
        }
        for (int ball = yellow; ball <= black; ++ball)
            table.put(ball, {-1.6, -0.6 + 0.2 * (ball - yellow)});
        table.play.rules.in_hand = CueInHand::no;
        table.put(0, {-0.5, 0.0});
        table.put(1, {0.5, 0.0});
    }
    PoolSight look(std::optional<int> called = std::nullopt) const {
        return sight_of(table.scene, table.world, table.play, table.play.rules, called);
    }

    TableInPlay table;
};

constexpr double radius = 0.02625;

}  // namespace

TEST_CASE("a ball on in the open is no snooker") {
    const Sight sight;
    CHECK(sight.look() == PoolSight{.sees_one_full = true});
}

TEST_CASE("snookered: one side of the ball on is hidden, or all of it") {
    Sight sight;
    struct Place {
        double y;
        bool is_snookered;
        bool sees_full;
    };
    // The cue ball passes beside a ball half-way if their centres are two radii apart. On the way
    // to the ball's side it has gone one radius to the side there.
    for (const Place& each : {Place{0.0, true, false}, Place{1.9 * radius, true, false},
                              Place{2.2 * radius, true, true}, Place{2.95 * radius, true, true},
                              Place{3.1 * radius, false, true}}) {
        CAPTURE(each.y / radius);
        sight.table.put(blue, {0.0, each.y});
        CHECK(sight.look().is_snookered == each.is_snookered);
        CHECK(sight.look().sees_one_full == each.sees_full);
    }
}

TEST_CASE("another ball on in the open ends a snooker, and balls on do not hide each other") {
    Sight sight;
    sight.table.put(blue, {0.0, 0.0});
    CHECK(sight.look().is_snookered);
    CHECK(sight.look(blue).is_by_called);
    CHECK_FALSE(sight.look(pink).is_by_called);
    CHECK_FALSE(sight.look(std::nullopt).is_by_called);
    // In order, the blue itself is on.
    sight.table.play.rules.snooker.now.on = SnookerTurn::On::in_order;
    sight.table.play.rules.down |= 0xfffe;
    for (int ball = yellow; ball < blue; ++ball)
        sight.table.play.rules.down |= std::uint32_t{1} << ball;
    CHECK_FALSE(sight.look().is_snookered);
}

TEST_CASE("in hand, the best place of the D counts") {
    Sight sight;
    sight.table.put(blue, {0.0, 0.0});
    CHECK(sight.look().is_snookered);
    sight.table.play.rules.in_hand = CueInHand::in_d;
    CHECK_FALSE(sight.look().is_snookered);
}
