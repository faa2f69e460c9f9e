#include "game/pool/pool.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "game/pool/pool_words.h"
#include "game/pool/table_places.h"
#include "game/support/shipped.h"
#include "game/support/table_in_play.h"
#include "physics/world/fingerprint.h"

using namespace carom;

namespace {

// With a shot clock of so many seconds, and a race to so many frames.
Scene timed(const std::string& level, double clock, std::uint32_t race = 0) {
    Scene scene = test::shipped_level(level);
    scene.pool.clock = clock;
    scene.pool.race = race;
    return scene;
}

constexpr Vec2 corner{1.27 - 0.02, 0.635 - 0.02};

}  // namespace

TEST_CASE("a break is judged when the balls are at rest, and every ball is on the table or down") {
    for (const char* level : {"eight-ball", "nine-ball"}) {
        for (const double slant : {0.0, 0.15, 0.3}) {
            CAPTURE(level);
            CAPTURE(slant);
            TableInPlay table(level);
            const Vec2 at = table.scene.pool.racks[0].foot - table.place_of(0);
            table.shoot(at * (9.0 / length(at)) + Vec2{0.0, slant});
            CHECK(table.play.shots == 1);
            CHECK(table.play.shot.first_hit);
            CHECK(table.play.rules.phase != PoolPhase::breaking);
            for (int ball = 0; ball < 16; ++ball) {
                const auto id = table.play.balls[static_cast<std::size_t>(ball)];
                const bool was_there = ball < static_cast<int>(table.scene.world.balls().size());
                CAPTURE(ball);
                if (!was_there) CHECK_FALSE(id);
                if (id) CHECK(index_of(table.world, *id));
                if (was_there && table.play.rules.phase == PoolPhase::playing)
                    CHECK(id.has_value() != is_down(table.play.rules, ball));
            }
        }
    }
}

TEST_CASE("a pocketed cue ball is a scratch, and is placed on the head spot") {
    TableInPlay table("eight-ball");
    table.put(0, {1.0, 0.4});
    table.shoot((corner - Vec2{1.0, 0.4}) * 8.0);
    CHECK(table.play.last_foul == PoolFoul::scratch);
    REQUIRE(table.play.balls[0]);
    CHECK(length(table.place_of(0) - head_spot(table.scene)) < 1e-9);
    CHECK(head_spot(table.scene).x == doctest::Approx(-0.635));
    CHECK(table.play.rules.player == 1);
    CHECK(table.play.rules.in_hand == CueInHand::behind_head_string);
    const BallId cue = *table.play.balls[0];
    CHECK(refusal_to_place(table.scene, table.play, cue, {0.0, 0.0}));
    CHECK_FALSE(refusal_to_place(table.scene, table.play, cue, {-1.0, 0.2}));
}

TEST_CASE("a called ball in the called pocket decides the group, and the player continues") {
    TableInPlay table("eight-ball");
    table.play.rules.phase = PoolPhase::playing;
    table.play.rules.in_hand = CueInHand::no;
    const Vec2 object{1.0, 0.4};
    const Vec2 way = (corner - object) / length(corner - object);
    table.put(3, object);
    table.put(0, object - way * 0.3);
    int pocket = -1;
    for (std::size_t i = 0; i < table.scene.pool.pockets.size(); ++i) {
        const Vec2 place = table.scene.world.zones()[table.scene.pool.pockets[i]].shape.start;
        if (place.x > 1.0 && place.y > 0.5) pocket = static_cast<int>(i);
    }
    REQUIRE(pocket >= 0);
    table.play.call = {PoolCall::Kind::pot, 3, pocket};
    table.shoot(way * 2.0);
    CHECK(table.play.last_foul == PoolFoul::none);
    CHECK(is_down(table.play.rules, 3));
    CHECK_FALSE(table.play.balls[3]);
    CHECK(table.play.rules.player == 0);
    CHECK(table.play.rules.group == PoolGroup::solids);
}

TEST_CASE("the 8 into the called pocket wins when it is its turn, and loses earlier") {
    for (const bool is_early : {false, true}) {
        CAPTURE(is_early);
        TableInPlay table("eight-ball");
        table.play.rules.phase = PoolPhase::playing;
        table.play.rules.in_hand = CueInHand::no;
        table.play.rules.group = PoolGroup::solids;
        if (!is_early) table.play.rules.down = 0xfeu;
        const Vec2 object{1.0, 0.4};
        const Vec2 way = (corner - object) / length(corner - object);
        table.put(8, object);
        table.put(0, object - way * 0.2);
        for (int pocket = 0; pocket < 6; ++pocket) {
            const Vec2 place =
                table.scene.world
                    .zones()[table.scene.pool.pockets[static_cast<std::size_t>(pocket)]]
                    .shape.start;
            if (place.x > 1.0 && place.y > 0.5) table.play.call = {PoolCall::Kind::pot, 8, pocket};
        }
        table.world.edit_balls().roll[table.cue()] = {};
        table.shoot(way * 1.2);
        REQUIRE(table.play.rules.phase == PoolPhase::over);
        CHECK(table.play.rules.winner == (is_early ? 1 : 0));
    }
}

TEST_CASE("a weak break: the next player may have the balls reracked") {
    TableInPlay table("eight-ball");
    table.shoot({0.8, 0.0});
    REQUIRE(table.play.rules.phase == PoolPhase::choosing);
    CHECK(refusal_to_shoot(table.play, *table.play.balls[0]));
    make_choice(table.scene, table.world, table.play, PoolChoice::break_again);
    CHECK(table.play.rules.phase == PoolPhase::breaking);
    CHECK(table.play.rules.player == 1);
    CHECK(table.world.balls().size() == 16);
    for (int ball = 0; ball < 16; ++ball) {
        // A rack of its own: the numbers are shuffled again.
        const double from_foot = distance(table.place_of(ball), table.scene.pool.racks[0].foot);
        CHECK((from_foot < 0.3) == (ball != 0));
    }
}

TEST_CASE("a 9 that does not count is spotted on the foot spot, or behind it") {
    TableInPlay table("nine-ball");
    table.play.rules.phase = PoolPhase::playing;
    table.play.rules.may_push_out = true;
    table.play.call = {PoolCall::Kind::push_out, 0, 0};
    const Vec2 object{1.0, 0.4};
    const Vec2 way = (corner - object) / length(corner - object);
    table.put(9, object);
    table.put(0, object - way * 0.3);
    table.shoot(way * 2.0);
    REQUIRE(table.play.balls[9]);
    CHECK(table.place_of(9).y == doctest::Approx(0.0));
    CHECK(table.place_of(9).x >= 0.635 - 1e-9);
    CHECK(table.play.rules.choices.size() == 2);
}

TEST_CASE("a copy of world and rack, taken in the middle of a shot, ends with the same bits") {
    TableInPlay table("eight-ball");
    table.world.edit_balls().velocity[table.cue()] = {9.0, 0.2};
    begin_shot(table.world, table.play);
    for (int i = 0; i < 100; ++i)
        table.step();
    TableInPlay copy("eight-ball");
    copy.world = table.world;
    copy.play = table.play;
    table.wait();
    copy.wait();
    CHECK(fingerprint(table.world) == fingerprint(copy.world));
    CHECK(table.play == copy.play);
}

TEST_CASE("the end of the shot clock is a command, and a foul") {
    TableInPlay table(timed("eight-ball", 2.0));
    const Command time_out = command::TimeOut{};
    // However long the balls lie still, the rules do not look at a clock.
    for (int i = 0; i < 600; ++i)
        table.step();
    CHECK(table.play.last_foul == PoolFoul::none);
    const Vec2 at = table.scene.pool.racks[0].foot - table.place_of(0);
    REQUIRE_FALSE(refusal(table.scene, table.world, table.play, time_out));
    execute(table.scene, table.world, table.play, time_out);
    CHECK(table.play.last_foul == PoolFoul::time);
    CHECK(table.play.shooter == 0);
    CHECK(table.play.rules.player == 1);
    CHECK(table.play.rules.phase == PoolPhase::breaking);

    // The shot itself is not limited.
    execute(table.scene, table.world, table.play,
            command::Strike{*table.play.balls[cue_ball], at * (9.0 / length(at))});
    CHECK(refusal(table.scene, table.world, table.play, time_out));
    while (table.play.is_shooting)
        table.step();
    CHECK(table.play.last_foul == PoolFoul::none);
    TableInPlay table_without_clock("nine-ball");
    CHECK(refusal(table_without_clock.scene, table_without_clock.world, table_without_clock.play,
                  time_out));
}

TEST_CASE("the player whose turn it is concedes the frame, between two shots") {
    TableInPlay table("eight-ball");
    const Command concede = command::Concede{};
    const auto is_refused = [&] {
        return refusal(table.scene, table.world, table.play, concede).has_value();
    };
    CHECK(is_refused());
    table.world.edit_balls().velocity[table.cue()] = {9.0, 0.2};
    begin_shot(table.world, table.play);
    CHECK(is_refused());
    table.wait();
    REQUIRE(table.play.rules.phase != PoolPhase::over);
    const int player = table.play.rules.player;
    REQUIRE_FALSE(is_refused());
    execute(table.scene, table.world, table.play, concede);
    CHECK(table.play.rules.winner == 1 - player);
    CHECK(table.play.rules.choices.empty());
    CHECK(table.play.frames[static_cast<std::size_t>(1 - player)] == 1);
    CHECK(outcome_text(table.play, {"you", "carom"}) ==
          (player == 0 ? "You concede. Carom wins the frame."
                       : "Carom concedes. You win the frame."));
    CHECK(is_refused());
    rack_again(table.scene, table.world, table.play);
    CHECK_FALSE(table.play.decision);
}

TEST_CASE("a match ends with the last frame of the race, and the next starts at 0-0") {
    TableInPlay table(timed("nine-ball", 0.0, 3));
    CHECK_FALSE(match_winner(table.play));
    table.play.frames = {1, 2};
    table.play.rules.phase = PoolPhase::playing;
    table.play.rules.in_hand = CueInHand::no;
    table.play.rules.player = 1;
    table.play.rules.down = 0b111111110;  // all but the 9
    for (int ball = 1; ball < 9; ++ball) {
        remove_ball(table.world, *table.play.balls[static_cast<std::size_t>(ball)]);
        table.play.balls[static_cast<std::size_t>(ball)].reset();
    }
    const Vec2 object{1.0, 0.4};
    const Vec2 way = (corner - object) / length(corner - object);
    table.put(9, object);
    table.put(0, object - way * 0.3);
    table.shoot(way * 2.0);
    CHECK(table.play.rules.winner == 1);
    CHECK(table.play.frames == std::array<std::uint32_t, 2>{1, 3});
    CHECK(match_winner(table.play) == 1);
    rack_again(table.scene, table.world, table.play);
    CHECK(table.play.frames == std::array<std::uint32_t, 2>{0, 0});
    CHECK_FALSE(match_winner(table.play));
    CHECK(table.play.breaker == 1);
}

TEST_CASE("a level chooses who breaks, how many fouls lose, and what the nine is worth") {
    const auto rules = [](PoolRules chosen, std::uint64_t seed = 0) {
        Scene scene = test::shipped_level("nine-ball");
        scene.pool.rules = chosen;
        scene.world.edit_definition().seed = seed;
        return *begin_pool(scene);
    };
    CHECK(rules({.fouls_that_lose = 2}).rules.options.fouls_that_lose == 2);
    CHECK_FALSE(rules({.nine_on_break_wins = false}).rules.options.nine_on_break_wins);
    int tossed = 0;
    for (std::uint64_t seed = 0; seed < 64; ++seed)
        tossed += rules({.is_tossed = true}, seed).breaker;
    CHECK(tossed > 16);
    CHECK(tossed < 48);
    for (const bool winner_breaks : {false, true}) {
        TableInPlay table("nine-ball");
        table.play.winner_breaks = winner_breaks;
        table.play.rules.phase = PoolPhase::over;
        table.play.rules.winner = 0;
        rack_again(table.scene, table.world, table.play);
        CHECK(table.play.breaker == (winner_breaks ? 0 : 1));
    }
}
