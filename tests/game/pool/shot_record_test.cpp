#include "game/pool/shot_record.h"

#include <doctest/doctest.h>

#include "game/pool/table_places.h"
#include "game/support/table_in_play.h"

using namespace carom;

TEST_CASE("a ball frozen to a rail counts for that rail only after leaving it") {
    for (const bool is_frozen : {true, false}) {
        CAPTURE(is_frozen);
        TableInPlay table("nine-ball");
        const double radius = table.world.balls().radius[table.cue()];
        // The cue ball pushes the 1 along the upper rail, softly.
        const double top = 0.635 - radius - (is_frozen ? 0.0 : 0.3 * radius);
        for (int ball = 2; ball < 10; ++ball)
            table.put(ball, {-1.0 + 0.1 * ball, -0.3});
        table.put(1, {0.3, top});
        table.put(0, {0.2, 0.5});
        table.play.rules.phase = PoolPhase::playing;
        table.play.rules.in_hand = CueInHand::no;
        const Vec2 way = table.place_of(1) - table.place_of(0);
        table.shoot(way * (0.6 / length(way)));
        CHECK(table.play.shot.first_hit == 1);
        CHECK((table.play.shot.railed & 2u) == (is_frozen ? 0u : 2u));
    }
}

TEST_CASE("a hit behind the head string is noted unless the cue ball has crossed it") {
    for (const bool crosses : {false, true}) {
        CAPTURE(crosses);
        TableInPlay table("nine-ball");
        const Vec2 head = head_spot(table.scene);
        const double out = rack_of(table.scene).toward.x;  // along x
        table.put(1, head + Vec2{-0.25 * out, 0.2});
        for (int ball = 2; ball < 10; ++ball)
            table.put(ball, {-0.1 * out + 0.1 * ball * out, -0.3});
        table.put(0, head + Vec2{-0.25 * out, 0.0});
        table.play.rules.phase = PoolPhase::playing;
        // Straight at the ball, or over the string and back from a cushion that stands there.
        if (crosses) table.play.has_crossed = true;
        table.world.edit_balls().velocity[table.cue()] = {0.0, 1.0};
        begin_shot(table.world, table.play);
        if (crosses) table.play.has_crossed = true;
        table.wait();
        CHECK(table.play.shot.first_hit == 1);
        CHECK(table.play.shot.hit_behind_string == !crosses);
    }
}
