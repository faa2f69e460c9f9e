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
        const PoolRuling ruling = judge_time(begin_rack(*referee, 0));
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
    CHECK_FALSE(may_call_shots(begin_rack(*referee_of("eightball"), 0)));
    CHECK(may_call_shots(eight_ball(open)));
    PoolState choosing = eight_ball(open);
    choosing.phase = PoolPhase::choosing;
    CHECK_FALSE(may_call_shots(choosing));
    CHECK_FALSE(may_call_shots(nine_ball(0, true)));
}
