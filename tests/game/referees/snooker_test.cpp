#include "game/referees/snooker.h"

#include <doctest/doctest.h>

#include "game/support/rulings.h"

using namespace carom;
using namespace carom::rulings;
using namespace carom::snooker;
using On = SnookerTurn::On;

namespace {

constexpr std::uint32_t no_reds = 0xfffe;

PoolState snooker_on(On on, std::uint32_t down = 0, std::array<int, 2> score = {}) {
    PoolState state = in_play("snooker", down);
    state.snooker.now.on = on;
    state.score = score;
    return state;
}

PoolState in_order(int lowest, std::array<int, 2> score = {}) {
    std::uint32_t down = no_reds;
    for (int ball = yellow; ball < lowest; ++ball)
        down |= std::uint32_t{1} << ball;
    return snooker_on(On::in_order, down, score);
}

PoolState free_ball(PoolState state) {
    state.snooker.now.is_free = true;
    return state;
}

PoolRuling seen(const PoolState& state, PoolRuling ruling, const PoolSight& sight) {
    state.referee->see(ruling, state, sight);
    return ruling;
}

constexpr PoolSight clear{.sees_one_full = true};
constexpr PoolSight hidden{.is_snookered = true};

}  // namespace

TEST_CASE("snooker: points, ball on and respots of fair strokes") {
    struct Stroke {
        std::string_view what;
        PoolState state;
        PoolCall call;
        PoolShot shot;
        int points;
        int next_player;
        On next_on;
        std::vector<int> respot;
    };
    const Stroke cases[] = {
        {"a red: a colour next",
         snooker_on(On::red),
         no_call,
         shot(1, {{1, 0}}),
         1,
         0,
         On::color,
         {}},
        {"two reds count two",
         snooker_on(On::red),
         no_call,
         shot(1, {{1, 0}, {7, 1}}),
         2,
         0,
         On::color,
         {}},
        {"no cushion is needed",
         snooker_on(On::red),
         no_call,
         shot(1, {}, false),
         0,
         1,
         On::red,
         {}},
        {"a colour returns: a red next",
         snooker_on(On::color, balls({1})),
         pot(black, 0),
         shot(black, {{black, 3}}),
         7,
         0,
         On::red,
         {black}},
        {"a colour without a call is the one that is hit",
         snooker_on(On::color, balls({1})),
         no_call,
         shot(blue, {{blue, 3}}),
         5,
         0,
         On::red,
         {blue}},
        {"any pocket will do",
         snooker_on(On::color, balls({1})),
         pot(pink, 0),
         shot(pink, {{pink, 5}}),
         6,
         0,
         On::red,
         {pink}},
        {"a colour missed: a red next",
         snooker_on(On::color, balls({1})),
         pot(pink, 0),
         shot(pink),
         0,
         1,
         On::red,
         {}},
        {"the colour after the last red returns: the yellow next",
         snooker_on(On::color, no_reds),
         pot(green, 0),
         shot(green, {{green, 1}}),
         3,
         0,
         On::in_order,
         {green}},
        {"the last red missed its colour",
         snooker_on(On::color, no_reds),
         pot(green, 0),
         shot(green),
         0,
         1,
         On::in_order,
         {}},
        {"in order: the yellow stays down",
         in_order(yellow),
         no_call,
         shot(yellow, {{yellow, 1}}),
         2,
         0,
         On::in_order,
         {}},
        {"in order: the pink",
         in_order(pink),
         no_call,
         shot(pink, {{pink, 1}}),
         6,
         0,
         On::in_order,
         {}},
    };
    for (const Stroke& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = seen(each.state, judge(each.state, each.call, each.shot), clear);
        CHECK(ruling.foul == PoolFoul::none);
        CHECK(ruling.next.score == std::array{each.points, 0});
        CHECK(ruling.next.player == each.next_player);
        CHECK(ruling.next.snooker.now.on == each.next_on);
        CHECK(ruling.respot == each.respot);
        CHECK(ruling.next.phase == PoolPhase::playing);
    }
}

TEST_CASE("snooker: fouls, and what they are worth") {
    struct Foul {
        std::string_view what;
        PoolState state;
        PoolCall call;
        PoolShot shot;
        PoolFoul foul;
        int penalty;
        std::vector<int> respot;
        CueInHand in_hand = CueInHand::no;
    };
    const CueInHand in_d = CueInHand::in_d;
    const Foul cases[] = {
        {"nothing hit: 4", snooker_on(On::red), no_call, shot({}), PoolFoul::no_hit, 4, {}},
        {"the black first when on a red: 7",
         snooker_on(On::red),
         no_call,
         shot(black),
         PoolFoul::wrong_ball,
         7,
         {}},
        {"the yellow first when on a red: 4",
         snooker_on(On::red),
         no_call,
         shot(yellow),
         PoolFoul::wrong_ball,
         4,
         {}},
        {"the white falls",
         snooker_on(On::red),
         no_call,
         shot(1, {{0, 2}}),
         PoolFoul::scratch,
         4,
         {},
         in_d},
        {"the red that fell with it stays down",
         snooker_on(On::red),
         no_call,
         shot(1, {{1, 0}, {0, 2}}),
         PoolFoul::scratch,
         4,
         {},
         in_d},
        {"a colour falls when on a red",
         snooker_on(On::red),
         no_call,
         shot(1, {{pink, 0}}),
         PoolFoul::wrong_pot,
         6,
         {pink}},
        {"the dearest ball counts",
         snooker_on(On::red),
         no_call,
         shot(blue, {{pink, 0}, {black, 1}}),
         PoolFoul::wrong_ball,
         7,
         {black, pink}},
        {"a red first when on a colour",
         snooker_on(On::color, balls({1})),
         pot(black, 0),
         shot(2),
         PoolFoul::wrong_ball,
         7,
         {}},
        {"a red first and no colour was named",
         snooker_on(On::color, balls({1})),
         no_call,
         shot(2),
         PoolFoul::wrong_ball,
         7,
         {}},
        {"another colour than the named one",
         snooker_on(On::color, balls({1})),
         pot(blue, 0),
         shot(green),
         PoolFoul::wrong_ball,
         5,
         {}},
        {"a red falls when on a colour",
         snooker_on(On::color, balls({1})),
         pot(blue, 0),
         shot(blue, {{2, 0}}),
         PoolFoul::wrong_pot,
         5,
         {}},
        {"the named colour falls with the white",
         snooker_on(On::color, balls({1})),
         pot(pink, 0),
         shot(pink, {{pink, 1}, {0, 0}}),
         PoolFoul::scratch,
         6,
         {pink},
         in_d},
        {"in order: the next colour first",
         in_order(blue),
         no_call,
         shot(black),
         PoolFoul::wrong_ball,
         7,
         {}},
        {"in order: the ball on falls with another",
         in_order(blue),
         no_call,
         shot(blue, {{blue, 0}, {pink, 1}}),
         PoolFoul::wrong_pot,
         6,
         {pink, blue}},
        {"in order: nothing hit costs the ball on",
         in_order(pink),
         no_call,
         shot({}),
         PoolFoul::no_hit,
         6,
         {}},
    };
    for (const Foul& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = seen(each.state, judge(each.state, each.call, each.shot), clear);
        CHECK(ruling.foul == each.foul);
        CHECK(ruling.penalty == each.penalty);
        CHECK(ruling.next.score == std::array{0, each.penalty});
        CHECK(ruling.respot == each.respot);
        CHECK(ruling.next.in_hand == each.in_hand);
        CHECK(ruling.next.player == 1);
        CHECK(ruling.next.phase == PoolPhase::choosing);
    }
}

TEST_CASE(
    "snooker: after a foul that snookers, any ball is free and has the value of the ball on") {
    const PoolState before = snooker_on(On::red);
    const PoolRuling foul = seen(before, judge(before, no_call, shot({})), hidden);
    CHECK(foul.next.snooker.now.is_free);
    const PoolState state = choose(foul.next, PoolChoice::take_table).next;
    CHECK(may_hit_first(state, black));
    CHECK(may_call(state, PoolCall::Kind::pot));
    CHECK_FALSE(choose(foul.next, PoolChoice::return_push).next.snooker.now.is_free);
    CHECK_FALSE(seen(before, judge(before, no_call, shot({})), clear).next.snooker.now.is_free);
    CHECK_FALSE(seen(before, judge(before, no_call, shot(1)), hidden).next.snooker.now.is_free);

    struct Free {
        std::string_view what;
        PoolState state;
        PoolCall call;
        PoolShot shot;
        int points;
        On next_on;
        std::vector<int> respot;
        int penalty = 0;
    };
    const Free cases[] = {
        {"for a red",
         free_ball(snooker_on(On::red)),
         pot(black, 0),
         shot(black, {{black, 1}}),
         1,
         On::color,
         {black}},
        {"and a red with it",
         free_ball(snooker_on(On::red)),
         pot(black, 0),
         shot(black, {{black, 1}, {3, 0}}),
         2,
         On::color,
         {black}},
        {"a red by way of it",
         free_ball(snooker_on(On::red)),
         pot(black, 0),
         shot(black, {{3, 0}}),
         1,
         On::color,
         {}},
        {"in order",
         free_ball(in_order(green)),
         pot(blue, 0),
         shot(blue, {{blue, 1}}),
         3,
         On::in_order,
         {blue}},
        {"in order, and the ball on with it",
         free_ball(in_order(green)),
         pot(blue, 0),
         shot(blue, {{blue, 1}, {green, 0}}),
         3,
         On::in_order,
         {blue}},
        {"the ball on may be named too",
         free_ball(in_order(green)),
         pot(green, 0),
         shot(green, {{green, 1}}),
         3,
         On::in_order,
         {}},
        {"another ball first",
         free_ball(snooker_on(On::red)),
         pot(black, 0),
         shot(pink),
         0,
         On::red,
         {},
         6},
        {"a red first, but the black was named",
         free_ball(snooker_on(On::red)),
         pot(black, 0),
         shot(3),
         0,
         On::red,
         {},
         4},
    };
    for (const Free& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = seen(each.state, judge(each.state, each.call, each.shot), clear);
        CHECK(ruling.penalty == each.penalty);
        CHECK(ruling.next.score == std::array{each.points, each.penalty});
        CHECK(ruling.next.snooker.now.on == each.next_on);
        CHECK(ruling.respot == each.respot);
        CHECK_FALSE(ruling.next.snooker.now.is_free);
    }
}

TEST_CASE(
    "snooker: to snooker behind the free ball is a foul, unless only pink and black are left") {
    constexpr PoolSight by_free{.is_snookered = true, .is_by_called = true};
    const PoolState reds = free_ball(snooker_on(On::red));
    const PoolRuling foul = seen(reds, judge(reds, pot(black, 0), shot(black)), by_free);
    CHECK(foul.foul == PoolFoul::hidden);
    CHECK(foul.penalty == 4);
    CHECK(foul.next.player == 1);
    CHECK(foul.next.score == std::array{0, 4});
    CHECK(foul.next.snooker.now.is_free);
    CHECK(foul.next.phase == PoolPhase::choosing);
    const PoolState last = free_ball(in_order(pink));
    CHECK(seen(last, judge(last, pot(black, 0), shot(black)), by_free).foul == PoolFoul::none);
    CHECK(seen(reds, judge(reds, pot(black, 0), shot(black)), hidden).foul == PoolFoul::none);
}

TEST_CASE("snooker: a miss may be played again from the same place") {
    using enum PoolChoice;
    PoolState state = snooker_on(On::red, balls({1}));
    state.snooker.now.sees_one_full = false;
    const PoolState after = judge(state, no_call, shot({})).next;
    CHECK(after.choices == std::vector{take_table, return_push, replace});
    const PoolRuling again = choose(after, replace);
    CHECK(again.put_back);
    CHECK(again.next.player == 0);
    CHECK(again.next.snooker.now.on == On::red);
    CHECK(again.next.down == balls({1}));
    CHECK(again.next.score == std::array{0, 4});
    CHECK(again.next.snooker.misses == 0);
    CHECK_FALSE(choose(after, return_push).put_back);
    CHECK(choose(after, take_table).next.player == 1);
    // A ball on was hit first: no miss.
    CHECK(judge(state, no_call, shot(2, {{0, 1}})).next.choices.size() == 2);
    // A colour that fell comes back, and was to be played.
    PoolState on_color = snooker_on(On::color, balls({1}));
    on_color.snooker.now.sees_one_full = false;
    const PoolState missed = judge(on_color, pot(black, 0), shot(3)).next;
    CHECK(choose(missed, replace).next.snooker.now.on == On::color);
}

TEST_CASE(
    "snooker: no miss is called when penalty points are needed, unless the ball on is in view") {
    PoolState behind = in_order(pink, {0, 40});
    behind.snooker.now.sees_one_full = false;
    CHECK(judge(behind, no_call, shot({})).next.choices.size() == 2);
    behind.snooker.now.sees_one_full = true;
    CHECK(judge(behind, no_call, shot({})).next.choices.size() == 3);
}

TEST_CASE("snooker: a third miss in a row with the ball on in full view loses the frame") {
    PoolState state = snooker_on(On::red);
    for (int miss = 0; miss < 2; ++miss) {
        CHECK(is_warned(state) == false);
        const PoolRuling ruling = judge(state, no_call, shot({}));
        REQUIRE_FALSE(ruling.next.winner);
        state = choose(ruling.next, PoolChoice::replace).next;
    }
    CHECK(is_warned(state));
    CHECK(judge(state, no_call, shot({})).next.winner == 1);
    CHECK_FALSE(judge(state, no_call, shot(4)).next.winner);
}

TEST_CASE("snooker: with only the black left, the first score or foul ends the frame") {
    CHECK(judge(in_order(black, {10, 12}), no_call, shot(black, {{black, 0}})).next.winner == 0);
    CHECK(judge(in_order(black, {30, 12}), no_call, shot({})).next.winner == 0);
    CHECK(judge(in_order(black, {10, 12}), no_call, shot({})).next.winner == 1);
    CHECK_FALSE(judge(in_order(black, {10, 12}), no_call, shot(black)).next.winner);
    CHECK_FALSE(judge(in_order(pink, {10, 12}), no_call, shot(pink, {{pink, 0}})).next.winner);
}

TEST_CASE("snooker: equal scores bring the black back, and a coin decides who plays from the D") {
    using enum PoolChoice;
    for (const PoolShot& last : {shot(black, {{black, 0}}), shot({})}) {
        const bool is_pot = last.first_hit.has_value();
        const PoolState state = in_order(black, is_pot ? std::array{10, 17} : std::array{17, 10});
        const PoolRuling tied = judge(state, no_call, last);
        CHECK_FALSE(tied.next.winner);
        CHECK(tied.toss);
        CHECK(tied.respot == std::vector<int>{black});
        CHECK(tied.next.in_hand == CueInHand::in_d);
        CHECK(tied.next.choices == std::vector{take_table, return_push});
        const PoolState plays = choose(tied.next, take_table).next;
        CHECK(may_hit_first(plays, black));
        CHECK(judge(plays, no_call, shot(black, {{black, 1}})).next.winner == plays.player);
        CHECK(judge(plays, no_call, shot({})).next.winner == 1 - plays.player);
        CHECK_FALSE(judge(plays, no_call, shot(black)).next.winner);
    }
}

TEST_CASE("snooker: a stroke that comes too late is a foul") {
    const PoolRuling late = judge_time(snooker_on(On::color, balls({1})));
    CHECK(late.foul == PoolFoul::time);
    CHECK(late.next.score == std::array{0, 7});
    CHECK(late.next.player == 1);
    CHECK(judge_time(in_order(black, {3, 20})).next.winner == 1);
}

TEST_CASE("snooker: a maximum break, and the words on the way") {
    PoolState state = begin_rack(*referee_of("snooker"), 0);
    CHECK(state.referee->target_text(state) == "on a red, 147 left");
    const auto play = [&](const PoolCall& call, int ball) {
        const PoolRuling ruling = judge(state, call, shot(ball, {{ball, 0}}));
        state = seen(state, ruling, clear).next;
    };
    for (int red = 1; red <= red_count; ++red) {
        play(no_call, red);
        if (red == 1) CHECK(state.referee->target_text(state) == "on a colour, break 1, 146 left");
        play(pot(black, 0), black);
    }
    CHECK(state.referee->target_text(state) == "on the yellow, break 120, 27 left");
    for (int color = yellow; color <= black; ++color)
        play(no_call, color);
    CHECK(state.winner == 0);
    CHECK(state.referee->score_text(state) == "147:0");
}
