#include <doctest/doctest.h>

#include "game/support/rulings.h"

using namespace carom;
using namespace carom::rulings;

namespace {

constexpr int right = 4;
constexpr int left = 5;

// Player 0 broke, and has the pocket on the right.
PoolState one_pocket(std::uint32_t down = 0, std::array<int, 2> score = {}) {
    PoolState state = in_play("onepocket", down);
    state.options.foot_pockets = {right, left};
    state.score = score;
    return state;
}

}  // namespace

TEST_CASE("one-pocket: what counts, what returns, who goes on") {
    struct OneShot {
        std::string_view what;
        PoolState state;
        PoolShot shot;
        std::array<int, 2> score;
        int next_player;
        std::vector<int> respot;
        PoolFoul foul = PoolFoul::none;
        CueInHand in_hand = CueInHand::no;
    };
    PoolState owing = one_pocket();
    owing.score = {-1, 0};
    const OneShot cases[] = {
        {"one's own pocket", one_pocket(), shot(3, {{3, right}}), {1, 0}, 0, {}},
        {"two at once", one_pocket(), shot(3, {{3, right}, {8, right}}), {2, 0}, 0, {}},
        {"a miss", one_pocket(), shot(3), {0, 0}, 1, {}},
        {"the opponent's pocket", one_pocket(), shot(3, {{3, left}}), {0, 1}, 1, {}},
        {"both pockets", one_pocket(), shot(3, {{3, left}, {4, right}}), {1, 1}, 0, {}},
        {"another pocket: the ball returns", one_pocket(), shot(3, {{3, 0}}), {0, 0}, 1, {3}},
        {"another pocket, but one's own too: it waits",
         one_pocket(),
         shot(3, {{3, 0}, {5, right}}),
         {1, 0},
         0,
         {}},
        {"a foul costs a ball",
         one_pocket(balls({9}), {1, 0}),
         shot({}),
         {0, 0},
         1,
         {9},
         PoolFoul::no_hit},
        {"a foul without a ball is owed",
         one_pocket(),
         shot(3, {}, false),
         {-1, 0},
         1,
         {},
         PoolFoul::no_rail},
        {"a scratch with a ball in one's own",
         one_pocket(),
         shot(3, {{3, right}, {0, 1}}),
         {-1, 0},
         1,
         {3},
         PoolFoul::scratch,
         CueInHand::behind_head_string},
        {"a scratch with a ball in the opponent's",
         one_pocket(),
         shot(3, {{3, left}, {0, 1}}),
         {-1, 0},
         1,
         {3},
         PoolFoul::scratch,
         CueInHand::behind_head_string},
        {"another foul with a ball in the opponent's",
         one_pocket(),
         shot({}, {{3, left}}),
         {-1, 1},
         1,
         {},
         PoolFoul::no_hit},
        {"a ball that was owed: it goes on, and the ball waits",
         owing,
         shot(3, {{3, right}}),
         {0, 0},
         0,
         {}},
    };
    for (const OneShot& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = judge(each.state, no_call, each.shot);
        CHECK(ruling.foul == each.foul);
        CHECK(ruling.next.score == each.score);
        CHECK(ruling.next.player == each.next_player);
        CHECK(ruling.respot == each.respot);
        CHECK(ruling.next.in_hand == each.in_hand);
    }
}

TEST_CASE("one-pocket: balls that wait return when the turn is over, or the table is empty") {
    const PoolState waits = judge(one_pocket(), no_call, shot(3, {{3, 0}, {5, right}})).next;
    CHECK(waits.waiting == balls({3}));
    CHECK(judge(waits, no_call, shot(7)).respot == std::vector<int>{3});
    CHECK(judge(waits, no_call, shot(7, {{7, right}})).respot.empty());
    PoolState nearly = waits;
    nearly.down = 0xfffe & ~balls({7});
    CHECK(judge(nearly, no_call, shot(7, {{7, right}})).respot == std::vector<int>{3});
}

TEST_CASE("one-pocket: eight balls win, three fouls in a row lose") {
    const std::uint32_t seven = balls({1, 2, 3, 4, 5, 6, 7});
    CHECK(judge(one_pocket(seven, {7, 0}), no_call, shot(9, {{9, right}})).next.winner == 0);
    CHECK(judge(one_pocket(seven, {0, 7}), no_call, shot(9, {{9, left}})).next.winner == 1);
    CHECK_FALSE(
        judge(one_pocket(seven, {7, 0}), no_call, shot(9, {{9, right}, {0, 1}})).next.winner);
    PoolState twice = one_pocket();
    twice.fouls = {2, 0};
    CHECK(judge(twice, no_call, shot({})).next.winner == 1);
    CHECK(judge_time(twice).next.winner == 1);
}

TEST_CASE("one-pocket: only one's own pocket serves, and the breaker has the right one") {
    PoolState state = one_pocket();
    for (int pocket = 0; pocket < 6; ++pocket)
        CHECK(state.referee->may_pocket(state, pocket) == (pocket == right));
    state.player = 1;
    CHECK(state.referee->may_pocket(state, left));
    state.breaker = 1;
    CHECK(state.referee->may_pocket(state, right));
}
