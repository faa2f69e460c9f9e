#include <doctest/doctest.h>

#include "game/support/rulings.h"

using namespace carom;
using namespace carom::rulings;

TEST_CASE("9-ball: turn, foul and end of a frame") {
    PoolState twice = nine_ball();
    twice.fouls = {2, 0};
    PoolState the_other_twice = nine_ball();
    the_other_twice.fouls = {0, 2};
    const Case cases[] = {
        {"the lowest falls: again",
         nine_ball(),
         no_call,
         shot(1, {{1, 3}}),
         PoolFoul::none,
         0,
         not_in_hand,
         {},
         {}},
        {"any ball by way of the lowest: again",
         nine_ball(balls({1})),
         no_call,
         shot(2, {{7, 3}}),
         PoolFoul::none,
         0,
         not_in_hand,
         {},
         {}},
        {"a miss: the turn passes",
         nine_ball(),
         no_call,
         shot(1),
         PoolFoul::none,
         1,
         not_in_hand,
         {},
         {}},
        {"not the lowest",
         nine_ball(),
         no_call,
         shot(2, {{2, 3}}),
         PoolFoul::wrong_ball,
         1,
         anywhere,
         {},
         {}},
        {"the lowest is down: the next one is",
         nine_ball(balls({1, 2})),
         no_call,
         shot(3),
         PoolFoul::none,
         1,
         not_in_hand,
         {},
         {}},
        {"no cushion",
         nine_ball(),
         no_call,
         shot(1, {}, false),
         PoolFoul::no_rail,
         1,
         anywhere,
         {},
         {}},
        {"nothing met", nine_ball(), no_call, shot({}), PoolFoul::no_hit, 1, anywhere, {}, {}},
        {"a scratch",
         nine_ball(),
         no_call,
         shot(1, {{1, 2}, {0, 2}}),
         PoolFoul::scratch,
         1,
         anywhere,
         {},
         {}},
        {"the 9 by way of the lowest",
         nine_ball(),
         no_call,
         shot(1, {{9, 0}}),
         PoolFoul::none,
         0,
         not_in_hand,
         {},
         0},
        {"the 9 alone",
         nine_ball(balls({1, 2, 3, 4, 5, 6, 7, 8})),
         no_call,
         shot(9, {{9, 0}}),
         PoolFoul::none,
         0,
         not_in_hand,
         {},
         0},
        {"the third foul in a row",
         twice,
         no_call,
         shot(2),
         PoolFoul::wrong_ball,
         0,
         not_in_hand,
         {},
         1},
        {"a foul after the other's two",
         the_other_twice,
         no_call,
         shot(2),
         PoolFoul::wrong_ball,
         1,
         anywhere,
         {},
         {}},
    };
    for (const Case& each : cases)
        check(each);
}

TEST_CASE("9-ball: a fair shot resets the count of consecutive fouls") {
    PoolState state = nine_ball();
    state.fouls = {2, 1};
    const PoolState fair = judge(state, no_call, shot(1)).next;
    CHECK(fair.fouls == std::array{0, 1});
    const PoolState foul = judge(fair, no_call, shot(5)).next;
    CHECK(foul.fouls == std::array{0, 2});
    CHECK(foul.player == 0);
    CHECK(judge(judge(foul, no_call, shot(1)).next, no_call, shot({})).next.winner == 0);
}

TEST_CASE("9-ball: a 9 that does not count is spotted") {
    const PoolRuling foul = judge(nine_ball(), no_call, shot(2, {{9, 0}, {5, 1}}));
    CHECK(foul.respot == std::vector<int>{9});
    CHECK_FALSE(is_down(foul.next, 9));
    CHECK(is_down(foul.next, 5));
    const PoolRuling pushed = judge(nine_ball(0, true), push_out, shot(2, {{9, 0}}));
    CHECK(pushed.foul == PoolFoul::none);
    CHECK(pushed.respot == std::vector<int>{9});
}

TEST_CASE("9-ball: the break") {
    const PoolState state = begin_rack(*referee_of("nineball"), 1);
    const PoolRuling fair = judge(state, no_call, break_shot(four_railed));
    CHECK(fair.foul == PoolFoul::none);
    CHECK(fair.next.player == 0);
    CHECK(fair.next.may_push_out);
    CHECK(judge(state, no_call, break_shot(0, {{4, 1}})).next.player == 1);
    CHECK(judge(state, no_call, break_shot(0, {{4, 1}})).next.may_push_out);
    const PoolRuling weak = judge(state, no_call, break_shot(three_railed));
    CHECK(weak.foul == PoolFoul::weak_break);
    CHECK(weak.next.player == 0);
    CHECK(weak.next.in_hand == anywhere);
    CHECK_FALSE(weak.next.may_push_out);
    PoolShot beside = break_shot(four_railed);
    beside.first_hit = 2;
    CHECK(judge(state, no_call, beside).foul == PoolFoul::wrong_ball);
    CHECK(judge(state, no_call, break_shot(four_railed, {{9, 2}})).next.winner == 1);

    const PoolState league =
        begin_rack(*referee_of("nineball"), 1, {.nine_on_break_wins = false, .fouls_that_lose = 3});
    const PoolRuling spotted = judge(league, no_call, break_shot(four_railed, {{9, 2}}));
    CHECK_FALSE(spotted.next.winner);
    CHECK(spotted.respot == std::vector<int>{9});
    CHECK(spotted.next.player == 1);
}

TEST_CASE("9-ball: a push-out") {
    using enum PoolChoice;
    const PoolState after_break = nine_ball(0, true);
    const PoolRuling pushed = judge(after_break, push_out, shot({}, {}, false));
    CHECK(pushed.foul == PoolFoul::none);
    CHECK(pushed.next.player == 1);
    CHECK(pushed.next.choices == std::vector{take_table, return_push});
    CHECK_FALSE(pushed.next.may_push_out);
    CHECK(choose(pushed.next, take_table).next.player == 1);
    CHECK(choose(pushed.next, return_push).next.player == 0);
    CHECK_FALSE(choose(pushed.next, return_push).next.may_push_out);
    CHECK(judge(after_break, push_out, shot({}, {{0, 1}}, false)).foul == PoolFoul::scratch);
    // Allowed only right after the break.
    CHECK(judge(nine_ball(), push_out, shot({}, {}, false)).foul == PoolFoul::no_hit);
    const PoolState later = judge(after_break, no_call, shot(1)).next;
    CHECK_FALSE(later.may_push_out);
}

TEST_CASE("9-ball: an expired clock counts among consecutive fouls, and the third loses") {
    PoolState state = nine_ball();
    state.fouls = {2, 1};
    const PoolRuling ruling = judge_time(state);
    CHECK(ruling.next.phase == PoolPhase::over);
    CHECK(ruling.next.winner == 1);
}
