#include <doctest/doctest.h>

#include "game/referees/eight_ball.h"
#include "game/support/rulings.h"
#include "level/scene/games.h"

using namespace carom;
using namespace carom::rulings;

TEST_CASE("an expired shot clock is a foul, and the opponent has ball in hand") {
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

TEST_CASE("a player who does not break in time lets the opponent break, behind the head string") {
    for (const Referee* referee : referees()) {
        CAPTURE(referee->game());
        const PoolState start = begin_rack(*referee, 0);
        if (start.phase != PoolPhase::breaking) continue;  // snooker has no break
        const PoolRuling ruling = judge_time(start);
        CHECK(ruling.foul == PoolFoul::time);
        CHECK(ruling.next.phase == PoolPhase::breaking);
        CHECK(ruling.next.player == 1);
        CHECK(ruling.next.in_hand == CueInHand::behind_head_string);
    }
}

TEST_CASE("a player who does not choose in time gets the first choice, without a foul") {
    PoolState state = eight_ball(std::nullopt);
    state.phase = PoolPhase::choosing;
    state.choices = {PoolChoice::take_table, PoolChoice::break_again, PoolChoice::let_break};
    CHECK(judge_time(state) == choose(state, PoolChoice::take_table));
    CHECK(judge_time(state).foul == PoolFoul::none);
}

TEST_CASE("every game of pool that a level can name has a referee, and no other game has") {
    for (const GameRow& game : game_rows()) {
        CAPTURE(game.name);
        const Referee* referee = referee_of(game.name);
        CHECK((referee != nullptr) == (game.family == GameRow::Family::pool));
        CHECK((referee != nullptr) == (game.rack != nullptr));
        if (referee) CHECK(referee->game() == game.name);
    }
}

TEST_CASE("the id of a game in fingerprints is its index among the referees") {
    for (std::size_t i = 0; i < referees().size(); ++i)
        CHECK(referees()[i]->id() == i);
    CHECK(referee_of("eightball")->id() == 0);
    CHECK(referee_of("nineball")->id() == 1);
}

TEST_CASE("calls: pots and safeties in 8-ball after the break, never in 9-ball") {
    using enum PoolCall::Kind;
    for (const PoolCall::Kind kind : {pot, safety}) {
        CHECK_FALSE(may_call(begin_rack(*referee_of("eightball"), 0), kind));
        CHECK(may_call(eight_ball(open), kind));
        PoolState choosing = eight_ball(open);
        choosing.phase = PoolPhase::choosing;
        CHECK_FALSE(may_call(choosing, kind));
        CHECK_FALSE(may_call(nine_ball(0, true), kind));
    }
}

TEST_CASE("in hand behind the head string, a ball behind it may be hit only from beyond it") {
    PoolState state = eight_ball(open);
    state.in_hand = CueInHand::behind_head_string;
    PoolShot behind = shot(3);
    behind.hit_behind_string = true;
    PoolState usual = eight_ball(open);
    PoolState breaking = begin_rack(*referee_of("eightball"), 0);
    const Case cases[] = {
        {"from behind", state, safety, behind, PoolFoul::behind_string, 1, anywhere, open, {}},
        {"beyond it", state, safety, shot(3), PoolFoul::none, 1, not_in_hand, open, {}},
        {"not in hand", usual, safety, behind, PoolFoul::none, 1, not_in_hand, open, {}},
    };
    for (const Case& each : cases)
        check(each);
    PoolShot break_behind = break_shot(four_railed);
    break_behind.hit_behind_string = true;
    CHECK(judge(breaking, no_call, break_behind).foul == PoolFoul::none);
}

TEST_CASE("the player whose next foul loses is warned") {
    PoolState state = nine_ball();
    CHECK_FALSE(is_warned(state));
    state.fouls = {2, 0};
    CHECK(is_warned(state));
    state.player = 1;
    CHECK_FALSE(is_warned(state));
    for (const int most : {0, 1}) {
        state.options.fouls_that_lose = most;
        state.fouls = {0, 0};
        CHECK_FALSE(is_warned(state));
    }
}

TEST_CASE("shots in a row that pocket nothing are a stalemate, if the level says how many") {
    PoolState state = eight_ball(PoolGroup::solids);
    state.breaker = 1;
    state.options.stalemate = 3;
    const PoolShot idle = shot(1);
    for (int i = 0; i < 2; ++i) {
        const PoolRuling ruling = judge(state, safety, idle);
        CHECK_FALSE(ruling.rerack);
        state = ruling.next;
        state.group.reset();
    }
    CHECK(judge(state, safety, shot(1, {{1, 0}})).next.idle_shots == 0);
    const PoolRuling ruling = judge(state, safety, idle);
    CHECK(ruling.rerack);
    CHECK(ruling.next == begin_rack(*referee_of("eightball"), 1, state.options));
    state.options.stalemate = 0;
    CHECK_FALSE(judge(state, safety, idle).rerack);
}
