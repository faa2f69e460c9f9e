#include <doctest/doctest.h>

#include "game/support/rulings.h"

using namespace carom;
using namespace carom::rulings;

namespace {

PoolState straight(std::uint32_t down = 0, std::array<int, 2> score = {}) {
    PoolState state = in_play("straightpool", down);
    state.options.points = 20;
    state.score = score;
    return state;
}

constexpr std::uint32_t all_but_5 = 0xffde;

}  // namespace

TEST_CASE("straight pool: points and turn") {
    struct Points {
        std::string_view what;
        PoolState state;
        PoolCall call;
        PoolShot shot;
        std::array<int, 2> score;
        int next_player;
        std::vector<int> respot;
        PoolFoul foul = PoolFoul::none;
        CueInHand in_hand = CueInHand::no;
    };
    const Points cases[] = {
        {"a called ball", straight(), pot(3, 1), shot(3, {{3, 1}}), {1, 0}, 0, {}},
        {"others fall with it", straight(), pot(3, 1), shot(9, {{7, 0}, {3, 1}}), {2, 0}, 0, {}},
        {"no cushion is needed then",
         straight(),
         pot(3, 1),
         shot(3, {{3, 1}}, false),
         {1, 0},
         0,
         {}},
        {"another ball than the called one returns",
         straight(),
         pot(3, 1),
         shot(3, {{4, 1}}),
         {0, 0},
         1,
         {4}},
        {"another pocket", straight(), pot(3, 1), shot(3, {{3, 2}}), {0, 0}, 1, {3}},
        {"a safety", straight(), safety, shot(3), {0, 0}, 1, {}},
        {"a ball falls on a safety, and returns",
         straight(),
         safety,
         shot(3, {{3, 2}}),
         {0, 0},
         1,
         {3}},
        {"a foul costs a point, and nothing counts",
         straight(),
         pot(3, 1),
         shot(3, {{3, 1}, {0, 0}}),
         {-1, 0},
         1,
         {3},
         PoolFoul::scratch,
         CueInHand::behind_head_string},
        {"a foul but no scratch: the cue ball stays",
         straight(),
         pot(3, 1),
         shot(3, {}, false),
         {-1, 0},
         1,
         {},
         PoolFoul::no_rail},
    };
    for (const Points& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = judge(each.state, each.call, each.shot);
        CHECK(ruling.foul == each.foul);
        CHECK(ruling.next.score == each.score);
        CHECK(ruling.next.player == each.next_player);
        CHECK(ruling.respot == each.respot);
        CHECK(ruling.next.in_hand == each.in_hand);
        CHECK_FALSE(ruling.rack_rest);
        CHECK_FALSE(ruling.next.winner);
    }
}

TEST_CASE("straight pool: fourteen are racked again, and the shooter goes on") {
    const std::uint32_t two_left = all_but_5 & ~balls({9});
    const PoolRuling ruling = judge(straight(two_left), pot(9, 0), shot(9, {{9, 0}}));
    CHECK(ruling.rack_rest);
    CHECK(ruling.next.down == 0);
    CHECK(ruling.next.player == 0);
    CHECK(ruling.next.score == std::array{1, 0});
    // The fifteenth fell too: all fifteen are racked.
    const PoolRuling both = judge(straight(two_left), pot(9, 0), shot(9, {{9, 0}, {5, 1}}));
    CHECK(both.rack_rest);
    CHECK(both.next.score == std::array{2, 0});
}

TEST_CASE("straight pool: the third foul in a row costs 16, and the offender breaks again") {
    PoolState state = straight(balls({1, 2}), {5, 9});
    state.fouls = {2, 1};
    const PoolRuling ruling = judge(state, pot(3, 1), shot({}));
    CHECK(ruling.penalty == 16);
    CHECK(ruling.rerack);
    CHECK(ruling.next.score == std::array{-11, 9});
    CHECK(ruling.next.fouls == std::array{0, 1});
    CHECK(ruling.next.phase == PoolPhase::breaking);
    CHECK(ruling.next.player == 0);
    CHECK(judge(state, pot(3, 1), shot(3)).next.fouls == std::array{0, 1});
    CHECK(is_warned(state));
}

TEST_CASE("straight pool: the opening break") {
    using enum PoolChoice;
    const PoolState state = begin_rack(*referee_of("straightpool"), 0);
    struct Opening {
        std::string_view what;
        PoolCall call;
        PoolShot shot;
        bool is_weak;
    };
    const Opening cases[] = {
        {"cue ball and two balls to a cushion", safety, {15, true, 0b111}, false},
        {"two balls without the cue ball", safety, {15, true, 0b110}, true},
        {"the cue ball and one ball", safety, {15, true, 0b011}, true},
        {"the called ball", pot(15, 1), {15, true, 0, {{15, 1}}}, false},
        {"another ball", pot(15, 1), {15, true, 0, {{14, 1}}}, true},
        {"a weak one and a scratch", safety, {15, true, 0b011, {{0, 1}}}, true},
    };
    for (const Opening& each : cases) {
        CAPTURE(each.what);
        const PoolRuling ruling = judge(state, each.call, each.shot);
        CHECK((ruling.foul == PoolFoul::weak_opening) == each.is_weak);
        CHECK(ruling.next.score[0] == (each.is_weak ? -2 : pocketed_by(each.shot, 15) ? 1 : 0));
        if (!each.is_weak) continue;
        CHECK(ruling.next.player == 1);
        CHECK(ruling.next.choices == std::vector{take_table, let_break});
        const PoolRuling again = choose(ruling.next, let_break);
        CHECK(again.rerack);
        CHECK(again.next.player == 0);
        CHECK(again.next.score == std::array{-2, 0});
        CHECK(again.next.phase == PoolPhase::breaking);
    }
}

TEST_CASE("straight pool: the points of the level win, and no foul on the way") {
    CHECK(judge(straight(0, {19, 3}), pot(3, 1), shot(3, {{3, 1}})).next.winner == 0);
    CHECK_FALSE(judge(straight(0, {18, 3}), pot(3, 1), shot(3, {{3, 1}})).next.winner);
    CHECK_FALSE(judge(straight(0, {19, 3}), pot(3, 1), shot(3, {{3, 1}, {0, 0}})).next.winner);
    CHECK(judge_time(straight(0, {19, 3})).next.score == std::array{18, 3});
}
