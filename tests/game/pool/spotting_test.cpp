#include "game/pool/spotting.h"

#include <doctest/doctest.h>

#include "game/pool/table_places.h"
#include "game/referees/snooker.h"
#include "game/support/table_in_play.h"

using namespace carom;
using namespace carom::snooker;

namespace {

void take(TableInPlay& table, int ball) {
    auto& slot = table.play.balls[static_cast<std::size_t>(ball)];
    remove_ball(table.world, *slot);
    slot.reset();
}

void spot(TableInPlay& table, int ball) {
    put_on_spot(table.scene, table.world, table.play, ball);
}

int balls_on(const TableInPlay& table) {
    return static_cast<int>(table.world.balls().size());
}

bool overlaps(const TableInPlay& table) {
    const auto& balls = table.world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (length(balls.position[i] - balls.position[j]) <
                (balls.radius[i] + balls.radius[j]) * (1.0 - 1e-9))
                return true;
    return false;
}

}  // namespace

TEST_CASE("snooker: a colour returns to its spot, else to the highest free one") {
    TableInPlay table("snooker");
    const Vec2 home = home_of(table.scene, blue);
    CHECK(home == Vec2{});
    take(table, blue);
    spot(table, blue);
    CHECK(table.place_of(blue) == home);

    // The spot of the blue is taken, and that of the black is free.
    take(table, black);
    take(table, blue);
    table.put(1, home);
    spot(table, blue);
    CHECK(table.place_of(blue) == home_of(table.scene, black));
    // The black's too: the pink has gone as well, so the black takes that spot.
    take(table, pink);
    spot(table, black);
    CHECK(table.place_of(black) == home_of(table.scene, pink));
    CHECK_FALSE(overlaps(table));
}

TEST_CASE("snooker: with all spots taken, a colour lies as near to its own as it can") {
    TableInPlay table("snooker");
    const double diameter = 2.0 * table.world.balls().radius[0];
    take(table, blue);
    table.put(1, home_of(table.scene, blue));
    spot(table, blue);
    const Vec2 place = table.place_of(blue);
    CHECK(place.y == 0.0);
    CHECK(place.x >= diameter);
    CHECK(place.x < diameter * 1.06);
    // The black has little room towards the cushion: it never leaves the table.
    take(table, black);
    for (int i = 0; i < 6; ++i)
        table.put(2 + i, home_of(table.scene, black) + Vec2{diameter * 1.001 * i, 0.0});
    spot(table, black);
    CHECK(is_on_table(table.scene, table.world, table.place_of(black), diameter / 2.0));
    CHECK(table.place_of(black).x < home_of(table.scene, black).x);
}

TEST_CASE("the cue ball in hand at snooker lies in the D") {
    const TableInPlay table("snooker");
    const Vec2 brown_spot = home_of(table.scene, brown);
    const Vec2 yellow_spot = home_of(table.scene, yellow);
    const double radius = length(yellow_spot - brown_spot);
    CHECK(radius == doctest::Approx(0.292));
    // The yellow is on the right of somebody who plays to the far end, the green on the left.
    CHECK(yellow_spot.y < 0.0);
    CHECK(home_of(table.scene, green).y > 0.0);
    const auto is_in_d = [&](Vec2 place) {
        return is_in_hand_area(table.scene, CueInHand::in_d, place);
    };
    CHECK(is_in_d(brown_spot));
    CHECK(is_in_d(yellow_spot));
    CHECK(is_in_d(brown_spot - Vec2{radius, 0.0}));
    CHECK(is_in_d(home_of(table.scene, cue_ball)));
    CHECK_FALSE(is_in_d(brown_spot + Vec2{0.01, 0.0}));
    CHECK_FALSE(is_in_d(brown_spot - Vec2{radius * 0.8, radius * 0.8}));
}

TEST_CASE("straight pool: the last ball and the cue ball leave the room of the triangle") {
    struct Rest {
        std::string_view what;
        std::optional<Vec2> last;  ///< none: pocketed too
        Vec2 cue;
        Vec2 last_after;
        std::optional<Vec2> cue_after;
        CueInHand in_hand;
    };
    const TableInPlay start("straight-pool");
    const Vec2 foot = rack_of(start.scene).foot;
    const Vec2 head = head_spot(start.scene);
    const Vec2 middle = (foot + head) * 0.5;
    const Vec2 in_rack = foot + Vec2{0.1, 0.0};
    const Vec2 free{0.2, 0.4};
    const Vec2 kitchen = head - Vec2{0.3, 0.2};
    const CueInHand behind = CueInHand::behind_head_string;
    const CueInHand no = CueInHand::no;
    const Rest cases[] = {
        {"nothing is in the way", free, kitchen, free, kitchen, no},
        {"the last ball", in_rack, free, head, free, no},
        {"the last ball, and the cue ball blocks the head spot", in_rack, head + Vec2{0.02, 0.0},
         middle, head + Vec2{0.02, 0.0}, no},
        {"the cue ball", free, in_rack, free, head, behind},
        {"the cue ball, and the last ball behind the string", kitchen, in_rack, kitchen, head, no},
        {"the cue ball, and the last ball on the head spot", head, in_rack, head, middle, no},
        {"both: fifteen are racked", in_rack + Vec2{0.06, 0.0}, in_rack, foot, head, behind},
        {"the last fell too: fifteen are racked", {}, free, foot, free, no},
    };
    for (const Rest& each : cases) {
        CAPTURE(each.what);
        TableInPlay table("straight-pool");
        for (int ball = 1; ball <= 15; ++ball)
            if (ball != 5 || !each.last) take(table, ball);
        table.put(0, each.cue);
        if (each.last) table.put(5, *each.last);
        table.play.rules.phase = PoolPhase::playing;
        table.play.rules.in_hand = no;
        rack_rest(table.scene, table.world, table.play);
        CHECK(balls_on(table) == 16);
        CHECK_FALSE(overlaps(table));
        CHECK(table.play.rules.in_hand == each.in_hand);
        CHECK(length(table.place_of(0) - *each.cue_after) < 1e-3);
        // A full rack has a ball on the foot spot, one of fourteen has none.
        bool has_apex = false;
        for (int ball = 1; ball <= 15; ++ball)
            has_apex = has_apex || length(table.place_of(ball) - foot) < 0.02;
        CHECK(has_apex == (each.last_after == foot));
        if (!has_apex) CHECK(table.place_of(5) == each.last_after);
    }
}

TEST_CASE("snooker: a miss puts all balls back, also those that fell") {
    TableInPlay table("snooker");
    table.put(0, home_of(table.scene, brown) - Vec2{0.2, 0.0});
    const World before = table.world;
    // Into the side of baulk: nothing is hit, or a wrong ball.
    table.shoot({0.0, -1.5});
    REQUIRE(table.play.last_foul == PoolFoul::no_hit);
    REQUIRE(table.play.rules.choices.back() == PoolChoice::replace);
    make_choice(table.scene, table.world, table.play, PoolChoice::replace);
    CHECK(table.play.rules.player == 0);
    CHECK(table.play.rules.in_hand == CueInHand::in_d);
    CHECK(balls_on(table) == 22);
    for (int ball = 0; ball <= black; ++ball) {
        const auto id = table.play.balls[static_cast<std::size_t>(ball)];
        REQUIRE(id);
        CHECK(table.place_of(ball) ==
              before.balls().position[*index_of(before, first_ball(table.scene, ball))]);
    }
}

TEST_CASE("one-pocket: the breaker's pocket is the right one at the foot") {
    const TableInPlay table("one-pocket");
    const auto pockets = foot_pockets(table.scene);
    const auto place_of = [&](int pocket) {
        return table.scene.world.zones()[table.scene.pool.pockets[static_cast<std::size_t>(pocket)]]
            .shape.start;
    };
    CHECK(place_of(pockets[0]).x > 1.2);
    CHECK(place_of(pockets[0]).y < -0.6);
    CHECK(place_of(pockets[1]).x > 1.2);
    CHECK(place_of(pockets[1]).y > 0.6);
}
