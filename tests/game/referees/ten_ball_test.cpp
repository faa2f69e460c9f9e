#include <doctest/doctest.h>

#include "game/support/rulings.h"

using namespace carom;
using namespace carom::rulings;

namespace {

PoolState ten_ball(std::uint32_t down = 0, bool may_push_out = false) {
    PoolState state = in_play("tenball", down);
    state.may_push_out = may_push_out;
    return state;
}

}  // namespace

TEST_CASE("10-ball: turn, foul and end of a frame") {
    PoolState twice = ten_ball();
    twice.fouls = {2, 0};
    const Case cases[] = {
        {"the called ball falls: again", ten_ball(), pot(1, 3), shot(1, {{1, 3}})},
        {"a called ball by way of the lowest: again", ten_ball(), pot(7, 3), shot(1, {{7, 3}})},
        {"and others with it", ten_ball(), pot(7, 3), shot(1, {{4, 0}, {7, 3}})},
        {"a miss: the turn passes", ten_ball(), pot(1, 3), shot(1), PoolFoul::none, 1},
        {"a safety without a pot: the turn passes", ten_ball(), safety, shot(1), PoolFoul::none, 1},
        {"not the lowest", ten_ball(), pot(2, 3), shot(2, {{2, 3}}), PoolFoul::wrong_ball, 1,
         anywhere},
        {"the lowest is down: the next one is", ten_ball(balls({1})), pot(2, 3), shot(2, {{2, 3}})},
        {"no cushion", ten_ball(), pot(1, 3), shot(1, {}, false), PoolFoul::no_rail, 1, anywhere},
        {"a scratch with the called ball", ten_ball(), pot(1, 3), shot(1, {{1, 3}, {0, 0}}),
         PoolFoul::scratch, 1, anywhere},
        {"the called 10 early wins", ten_ball(), pot(10, 2), shot(1, {{10, 2}}), PoolFoul::none, 0,
         not_in_hand, open, 0},
        {"the last ball wins", ten_ball(balls({1, 2, 3, 4, 5, 6, 7, 8, 9})), pot(10, 2),
         shot(10, {{10, 2}}), PoolFoul::none, 0, not_in_hand, open, 0},
        {"the third foul in a row loses", twice, pot(1, 0), shot(2), PoolFoul::wrong_ball, 0,
         not_in_hand, open, 1},
    };
    for (const Case& each : cases)
        check(each);
}

TEST_CASE("10-ball: a ball that was not called lets the opponent choose who shoots") {
    using enum PoolChoice;
    struct WrongPot {
        std::string_view what;
        PoolCall call;
        PoolShot shot;
        std::vector<int> respot;
    };
    const WrongPot cases[] = {
        {"another ball", pot(1, 3), shot(1, {{4, 0}}), {}},
        {"another pocket", pot(1, 3), shot(1, {{1, 0}}), {}},
        {"the 10, which returns", pot(1, 3), shot(1, {{10, 0}}), {10}},
        {"after a safety", safety, shot(1, {{1, 0}}), {}},
        {"nothing was called", no_call, shot(1, {{1, 0}}), {}},
    };
    for (const WrongPot& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = judge(ten_ball(), each.call, each.shot);
        CHECK(ruling.foul == PoolFoul::none);
        CHECK(ruling.next.player == 1);
        CHECK(ruling.next.choices == std::vector{take_table, return_push});
        CHECK(ruling.respot == each.respot);
        CHECK(choose(ruling.next, return_push).next.player == 0);
    }
}

TEST_CASE("10-ball: the break") {
    const PoolState state = begin_rack(*referee_of("tenball"), 0);
    CHECK_FALSE(may_call(state, PoolCall::Kind::pot));
    CHECK(judge(state, no_call, break_shot(four_railed)).next.player == 1);
    const PoolRuling made = judge(state, no_call, break_shot(0, {{4, 1}}));
    CHECK(made.next.player == 0);
    CHECK(made.next.may_push_out);
    CHECK(judge(state, no_call, break_shot(three_railed)).foul == PoolFoul::weak_break);
    const PoolRuling ten = judge(state, no_call, break_shot(four_railed, {{10, 1}}));
    CHECK_FALSE(ten.next.winner);
    CHECK(ten.respot == std::vector<int>{10});
    CHECK(ten.next.player == 0);
    const PoolRuling pushed = judge(ten_ball(0, true), push_out, shot({}, {}, false));
    CHECK(pushed.foul == PoolFoul::none);
    CHECK(pushed.next.choices.size() == 2);
    CHECK(judge_time(ten_ball()).next.fouls == std::array{1, 0});
}
