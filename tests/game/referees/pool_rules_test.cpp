#include "game/referees/pool_rules.h"

#include <string_view>

#include <doctest/doctest.h>

using namespace carom;

// The rules' cases as tables: who shoots next, with what in hand, and what came of it.
namespace {

constexpr PoolCall no_call{};
constexpr PoolCall safety{PoolCall::Kind::safety, 0, 0};
constexpr PoolCall push_out{PoolCall::Kind::push_out, 0, 0};

PoolCall pot(int ball, int pocket) {
    return {PoolCall::Kind::pot, ball, pocket};
}

// A shot that met `first`, then a cushion, and pocketed these.
PoolShot shot(std::optional<int> first, std::vector<PoolShot::Pocketed> pocketed = {},
              bool rail = true) {
    return {first, rail, 0, std::move(pocketed)};
}

PoolShot break_shot(std::uint32_t railed, std::vector<PoolShot::Pocketed> pocketed = {}) {
    return {1, true, railed, std::move(pocketed)};
}

constexpr std::uint32_t four_railed = 0b11110;
constexpr std::uint32_t three_railed = 0b01110;

std::uint32_t balls(std::initializer_list<int> which) {
    std::uint32_t set = 0;
    for (const int ball : which)
        set |= std::uint32_t{1} << ball;
    return set;
}

PoolState eight_ball(std::optional<PoolGroup> group, std::uint32_t down = 0) {
    PoolState state = begin_rack(PoolGame::eight_ball, 0);
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    state.group = group;
    state.down = down;
    return state;
}

PoolState nine_ball(std::uint32_t down = 0, bool may_push_out = false) {
    PoolState state = begin_rack(PoolGame::nine_ball, 0);
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    state.down = down;
    state.may_push_out = may_push_out;
    return state;
}

struct Case {
    std::string_view what;
    PoolState state;
    PoolCall call;
    PoolShot shot;
    PoolFoul foul = PoolFoul::none;
    int next_player = 0;
    CueInHand in_hand = CueInHand::no;
    std::optional<PoolGroup> group;
    std::optional<int> winner;
};

void check(const Case& each) {
    CAPTURE(each.what);
    const PoolRuling ruling = judge(each.state, each.call, each.shot);
    CHECK(ruling.foul == each.foul);
    CHECK(ruling.next.winner == each.winner);
    CHECK((ruling.next.phase == PoolPhase::over) == each.winner.has_value());
    CHECK(ruling.next.in_hand == each.in_hand);
    CHECK(ruling.next.group == each.group);
    if (!each.winner) CHECK(ruling.next.player == each.next_player);
}

constexpr auto open = std::nullopt;
constexpr auto solids = PoolGroup::solids;
constexpr auto stripes = PoolGroup::stripes;
constexpr auto anywhere = CueInHand::anywhere;
constexpr auto not_in_hand = CueInHand::no;
const std::uint32_t all_solids = balls({1, 2, 3, 4, 5, 6, 7});
const std::uint32_t all_stripes = balls({9, 10, 11, 12, 13, 14, 15});

}  // namespace

TEST_CASE("8-ball: whose turn, which group, which foul") {
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

TEST_CASE("8-ball: how it ends") {
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
    const PoolState state = begin_rack(PoolGame::eight_ball, 0);
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

TEST_CASE("8-ball: what is chosen after the break") {
    const PoolState state = begin_rack(PoolGame::eight_ball, 0);
    const PoolState weak = judge(state, no_call, break_shot(0)).next;
    CHECK(weak.player == 1);
    const PoolRuling taken = choose(weak, PoolChoice::take_table);
    CHECK(taken.next.player == 1);
    CHECK(taken.next.phase == PoolPhase::playing);
    CHECK_FALSE(taken.rerack);
    const PoolRuling again = choose(weak, PoolChoice::break_again);
    CHECK(again.rerack);
    CHECK(again.next == begin_rack(PoolGame::eight_ball, 1));
    CHECK(choose(weak, PoolChoice::let_break).next == begin_rack(PoolGame::eight_ball, 0));

    const PoolState on_eight = judge(state, no_call, break_shot(0, {{8, 1}, {3, 2}})).next;
    const PoolRuling spotted = choose(on_eight, PoolChoice::spot_eight);
    CHECK(spotted.respot == std::vector<int>{8});
    CHECK_FALSE(is_down(spotted.next, 8));
    CHECK(is_down(spotted.next, 3));
    CHECK(spotted.next.player == 0);
    CHECK(spotted.next.phase == PoolPhase::playing);
}

TEST_CASE("9-ball: whose turn, which foul, how it ends") {
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

TEST_CASE("9-ball: fouls in a row are forgotten with a fair shot") {
    PoolState state = nine_ball();
    state.fouls = {2, 1};
    const PoolState fair = judge(state, no_call, shot(1)).next;
    CHECK(fair.fouls == std::array{0, 1});
    const PoolState foul = judge(fair, no_call, shot(5)).next;
    CHECK(foul.fouls == std::array{0, 2});
    CHECK(foul.player == 0);
    CHECK(judge(judge(foul, no_call, shot(1)).next, no_call, shot({})).next.winner == 0);
}

TEST_CASE("9-ball: the 9 comes back where it does not count") {
    const PoolRuling foul = judge(nine_ball(), no_call, shot(2, {{9, 0}, {5, 1}}));
    CHECK(foul.respot == std::vector<int>{9});
    CHECK_FALSE(is_down(foul.next, 9));
    CHECK(is_down(foul.next, 5));
    const PoolRuling pushed = judge(nine_ball(0, true), push_out, shot(2, {{9, 0}}));
    CHECK(pushed.foul == PoolFoul::none);
    CHECK(pushed.respot == std::vector<int>{9});
}

TEST_CASE("9-ball: the break") {
    const PoolState state = begin_rack(PoolGame::nine_ball, 1);
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
        begin_rack(PoolGame::nine_ball, 1, {.nine_on_break_wins = false, .fouls_that_lose = 3});
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
    // Only right after the break.
    CHECK(judge(nine_ball(), push_out, shot({}, {}, false)).foul == PoolFoul::no_hit);
    const PoolState later = judge(after_break, no_call, shot(1)).next;
    CHECK_FALSE(later.may_push_out);
}

TEST_CASE("a rack of 8-ball from the break to the end") {
    PoolState state = begin_rack(PoolGame::eight_ball, 1);
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

TEST_CASE("the time for a shot runs out: a foul, and the other has the ball in hand") {
    const PoolRuling eight = judge_time(eight_ball(PoolGroup::solids));
    CHECK(eight.foul == PoolFoul::time);
    CHECK(eight.next.player == 1);
    CHECK(eight.next.in_hand == CueInHand::anywhere);
    CHECK(eight.next.phase == PoolPhase::playing);
    CHECK(eight.next.group == PoolGroup::solids);

    const PoolRuling nine = judge_time(nine_ball(0, true));
    CHECK(nine.next.player == 1);
    CHECK(nine.next.fouls == std::array{1, 0});
    CHECK_FALSE(nine.next.may_push_out);
}

TEST_CASE("who does not break in time leaves the break to the other, behind the head string") {
    for (const PoolGame game : {PoolGame::eight_ball, PoolGame::nine_ball}) {
        const PoolRuling ruling = judge_time(begin_rack(game, 0));
        CHECK(ruling.foul == PoolFoul::time);
        CHECK(ruling.next.phase == PoolPhase::breaking);
        CHECK(ruling.next.player == 1);
        CHECK(ruling.next.in_hand == CueInHand::behind_head_string);
    }
}

TEST_CASE("9-ball: running out of time counts among the fouls in a row, and the third loses") {
    PoolState state = nine_ball();
    state.fouls = {2, 1};
    const PoolRuling ruling = judge_time(state);
    CHECK(ruling.next.phase == PoolPhase::over);
    CHECK(ruling.next.winner == 1);
}

TEST_CASE("who does not choose in time takes the first choice, and that is no foul") {
    PoolState state = eight_ball(std::nullopt);
    state.phase = PoolPhase::choosing;
    state.choices = {PoolChoice::take_table, PoolChoice::break_again, PoolChoice::let_break};
    CHECK(judge_time(state) == choose(state, PoolChoice::take_table));
    CHECK(judge_time(state).foul == PoolFoul::none);
}
