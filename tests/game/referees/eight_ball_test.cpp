#include <doctest/doctest.h>

#include "game/referees/eight_ball.h"
#include "game/support/rulings.h"

using namespace carom;
using namespace carom::rulings;

TEST_CASE("8-ball: turn, group and foul after a shot") {
    const Case cases[] = {
        {"open table: a called solid gives the solids",
         eight_ball(open),
         pot(3, 2),
         shot(3, {{3, 2}}),
         PoolFoul::none,
         0,
         not_in_hand,
         solids,
         {}},
        {"open table: a called stripe by way of a solid gives the stripes",
         eight_ball(open),
         pot(11, 0),
         shot(2, {{11, 0}}),
         PoolFoul::none,
         0,
         not_in_hand,
         stripes,
         {}},
        {"open table: another ball than the called one gives nothing",
         eight_ball(open),
         pot(3, 2),
         shot(3, {{4, 2}}),
         PoolFoul::none,
         1,
         not_in_hand,
         open,
         {}},
        {"open table: another pocket than the called one gives nothing",
         eight_ball(open),
         pot(3, 2),
         shot(3, {{3, 1}}),
         PoolFoul::none,
         1,
         not_in_hand,
         open,
         {}},
        {"open table: nothing called gives nothing",
         eight_ball(open),
         no_call,
         shot(3, {{3, 1}}),
         PoolFoul::none,
         1,
         not_in_hand,
         open,
         {}},
        {"open table: the 8 must not be met first",
         eight_ball(open),
         pot(3, 1),
         shot(8, {{3, 1}}),
         PoolFoul::wrong_ball,
         1,
         anywhere,
         open,
         {}},
        {"open table: a foul gives no group",
         eight_ball(open),
         pot(3, 1),
         shot(3, {{3, 1}, {0, 4}}),
         PoolFoul::scratch,
         1,
         anywhere,
         open,
         {}},
        {"a called ball of one's own: again",
         eight_ball(solids),
         pot(5, 1),
         shot(5, {{5, 1}}),
         PoolFoul::none,
         0,
         not_in_hand,
         solids,
         {}},
        {"one's own by way of another of one's own: again",
         eight_ball(solids),
         pot(5, 1),
         shot(2, {{5, 1}}),
         PoolFoul::none,
         0,
         not_in_hand,
         solids,
         {}},
        {"more than the called one fell: again",
         eight_ball(solids),
         pot(5, 1),
         shot(5, {{12, 0}, {5, 1}}),
         PoolFoul::none,
         0,
         not_in_hand,
         solids,
         {}},
        {"another's ball called and made: the turn passes",
         eight_ball(solids),
         pot(12, 1),
         shot(5, {{12, 1}}),
         PoolFoul::none,
         1,
         not_in_hand,
         solids,
         {}},
        {"a safety: the turn passes though one fell",
         eight_ball(solids),
         safety,
         shot(5, {{5, 1}}),
         PoolFoul::none,
         1,
         not_in_hand,
         solids,
         {}},
        {"a miss: the turn passes",
         eight_ball(solids),
         pot(5, 1),
         shot(5),
         PoolFoul::none,
         1,
         not_in_hand,
         solids,
         {}},
        {"the other's ball first",
         eight_ball(solids),
         pot(5, 1),
         shot(12, {{5, 1}}),
         PoolFoul::wrong_ball,
         1,
         anywhere,
         solids,
         {}},
        {"the 8 first, with solids left",
         eight_ball(solids),
         pot(5, 1),
         shot(8, {{5, 1}}),
         PoolFoul::wrong_ball,
         1,
         anywhere,
         solids,
         {}},
        {"nothing met",
         eight_ball(solids),
         pot(5, 1),
         shot({}),
         PoolFoul::no_hit,
         1,
         anywhere,
         solids,
         {}},
        {"no cushion after the hit",
         eight_ball(solids),
         pot(5, 1),
         shot(5, {}, false),
         PoolFoul::no_rail,
         1,
         anywhere,
         solids,
         {}},
        {"a ball pocketed needs no cushion",
         eight_ball(solids),
         pot(5, 1),
         shot(5, {{5, 1}}, false),
         PoolFoul::none,
         0,
         not_in_hand,
         solids,
         {}},
        {"a scratch",
         eight_ball(solids),
         pot(5, 1),
         shot(5, {{5, 1}, {0, 3}}),
         PoolFoul::scratch,
         1,
         anywhere,
         solids,
         {}},
        {"on the 8: a miss",
         eight_ball(solids, all_solids),
         pot(8, 1),
         shot(8),
         PoolFoul::none,
         1,
         not_in_hand,
         solids,
         {}},
        {"on the 8: another ball first",
         eight_ball(solids, all_solids),
         pot(8, 1),
         shot(12),
         PoolFoul::wrong_ball,
         1,
         anywhere,
         solids,
         {}},
        {"on the 8: a scratch without it loses nothing but the turn",
         eight_ball(solids, all_solids),
         pot(8, 1),
         shot(8, {{0, 1}}),
         PoolFoul::scratch,
         1,
         anywhere,
         solids,
         {}},
    };
    for (const Case& each : cases)
        check(each);
}

TEST_CASE("8-ball: the end of a frame") {
    const Case cases[] = {
        {"the 8 in the called pocket", eight_ball(solids, all_solids), pot(8, 1), shot(8, {{8, 1}}),
         PoolFoul::none, 0, not_in_hand, solids, 0},
        {"the other's last group, the 8 called", eight_ball(stripes, all_stripes), pot(8, 5),
         shot(8, {{8, 5}}, false), PoolFoul::none, 0, not_in_hand, stripes, 0},
        {"the 8 with one's last ball", eight_ball(solids, all_solids & ~balls({5})), pot(5, 1),
         shot(5, {{5, 1}, {8, 2}}), PoolFoul::none, 0, not_in_hand, solids, 1},
        {"the 8 too early", eight_ball(solids), pot(5, 1), shot(5, {{8, 1}}), PoolFoul::none, 0,
         not_in_hand, solids, 1},
        {"the 8 in the wrong pocket", eight_ball(solids, all_solids), pot(8, 1), shot(8, {{8, 2}}),
         PoolFoul::none, 0, not_in_hand, solids, 1},
        {"the 8 not called", eight_ball(solids, all_solids), no_call, shot(8, {{8, 2}}),
         PoolFoul::none, 0, not_in_hand, solids, 1},
        {"the 8 with a scratch", eight_ball(solids, all_solids), pot(8, 1),
         shot(8, {{8, 1}, {0, 2}}), PoolFoul::scratch, 0, not_in_hand, solids, 1},
        {"the 8 on an open table", eight_ball(open), pot(3, 1), shot(3, {{8, 1}}), PoolFoul::none,
         0, not_in_hand, open, 1},
        {"the 8 after the wrong ball", eight_ball(solids, all_solids), pot(8, 1),
         shot(12, {{8, 1}}), PoolFoul::wrong_ball, 0, not_in_hand, solids, 1},
    };
    for (const Case& each : cases)
        check(each);
}

TEST_CASE("8-ball: the break") {
    const PoolState state = begin_rack(*referee_of("eightball"), 0);
    using enum PoolChoice;
    struct BreakCase {
        std::string_view what;
        PoolShot shot;
        PoolFoul foul;
        int next_player;
        CueInHand in_hand;
        std::vector<PoolChoice> choices;
    };
    const BreakCase cases[] = {
        {"four to the cushions", break_shot(four_railed), PoolFoul::none, 1, not_in_hand, {}},
        {"a ball falls: again, and the table is open",
         break_shot(0, {{3, 1}}),
         PoolFoul::none,
         0,
         not_in_hand,
         {}},
        {"three to the cushions",
         break_shot(three_railed),
         PoolFoul::none,
         1,
         not_in_hand,
         {take_table, break_again, let_break}},
        {"the cue ball's own cushion does not count",
         break_shot(three_railed | 1),
         PoolFoul::none,
         1,
         not_in_hand,
         {take_table, break_again, let_break}},
        {"a scratch",
         break_shot(four_railed, {{0, 1}}),
         PoolFoul::scratch,
         1,
         CueInHand::behind_head_string,
         {}},
        {"a weak break and a scratch",
         break_shot(0, {{0, 1}}),
         PoolFoul::scratch,
         1,
         CueInHand::behind_head_string,
         {take_table, break_again, let_break}},
        {"the 8",
         break_shot(four_railed, {{8, 1}}),
         PoolFoul::none,
         0,
         not_in_hand,
         {spot_eight, break_again}},
        {"the 8 and a scratch: the other chooses",
         break_shot(four_railed, {{8, 1}, {0, 2}}),
         PoolFoul::scratch,
         1,
         CueInHand::behind_head_string,
         {spot_eight, break_again}},
    };
    for (const BreakCase& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = judge(state, no_call, each.shot);
        CHECK(ruling.foul == each.foul);
        CHECK(ruling.next.player == each.next_player);
        CHECK(ruling.next.in_hand == each.in_hand);
        CHECK(ruling.next.choices == each.choices);
        CHECK(ruling.next.phase ==
              (each.choices.empty() ? PoolPhase::playing : PoolPhase::choosing));
        CHECK_FALSE(ruling.next.group);
        CHECK_FALSE(ruling.next.winner);
    }
}

TEST_CASE("8-ball: choices after the break") {
    const PoolState state = begin_rack(*referee_of("eightball"), 0);
    const PoolState weak = judge(state, no_call, break_shot(0)).next;
    CHECK(weak.player == 1);
    const PoolRuling taken = choose(weak, PoolChoice::take_table);
    CHECK(taken.next.player == 1);
    CHECK(taken.next.phase == PoolPhase::playing);
    CHECK_FALSE(taken.rerack);
    const PoolRuling again = choose(weak, PoolChoice::break_again);
    CHECK(again.rerack);
    CHECK(again.next == begin_rack(*referee_of("eightball"), 1));
    CHECK(choose(weak, PoolChoice::let_break).next == begin_rack(*referee_of("eightball"), 0));

    const PoolState on_eight = judge(state, no_call, break_shot(0, {{8, 1}, {3, 2}})).next;
    const PoolRuling spotted = choose(on_eight, PoolChoice::spot_eight);
    CHECK(spotted.respot == std::vector<int>{8});
    CHECK_FALSE(is_down(spotted.next, 8));
    CHECK(is_down(spotted.next, 3));
    CHECK(spotted.next.player == 0);
    CHECK(spotted.next.phase == PoolPhase::playing);
}

TEST_CASE("a rack of 8-ball from the break to the end") {
    PoolState state = begin_rack(*referee_of("eightball"), 1);
    const auto play = [&](const PoolCall& call, const PoolShot& each) {
        state = judge(state, call, each).next;
    };
    play(no_call, break_shot(0, {{10, 0}}));
    CHECK(state.player == 1);
    play(pot(9, 1), shot(9, {{9, 1}}));
    CHECK(group_of_player(state, 1) == stripes);
    CHECK(group_of_player(state, 0) == solids);
    play(safety, shot(11));
    for (const int ball : {1, 2, 3, 4, 5, 6, 7})
        play(pot(ball, 3), shot(ball, {{ball, 3}}));
    CHECK(state.player == 0);
    CHECK(may_hit_first(state, 8));
    CHECK_FALSE(may_hit_first(state, 11));
    play(pot(8, 2), shot(8, {{8, 2}}));
    CHECK(state.winner == 0);
}
