#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "game/referees/referee.h"

/// Shots, states and cases for tests of referees: who shoots next, where the cue ball may be
/// placed, and why.
namespace carom::rulings {

inline constexpr PoolCall no_call{};
inline constexpr PoolCall safety{PoolCall::Kind::safety, 0, 0};
inline constexpr PoolCall push_out{PoolCall::Kind::push_out, 0, 0};

inline PoolCall pot(int ball, int pocket) {
    return {PoolCall::Kind::pot, ball, pocket};
}

/// A shot that first hit `first`, then drove a ball to a cushion, and pocketed these balls.
inline PoolShot shot(std::optional<int> first, std::vector<PoolShot::Pocketed> pocketed = {},
                     bool rail = true) {
    return {first, rail, 0, std::move(pocketed)};
}

inline PoolShot break_shot(std::uint32_t railed, std::vector<PoolShot::Pocketed> pocketed = {}) {
    return {1, true, railed, std::move(pocketed)};
}

inline constexpr std::uint32_t four_railed = 0b11110;
inline constexpr std::uint32_t three_railed = 0b01110;

inline std::uint32_t balls(std::initializer_list<int> which) {
    std::uint32_t set = 0;
    for (const int ball : which)
        set |= std::uint32_t{1} << ball;
    return set;
}

/// A rack of a game in play, player 0 to shoot.
inline PoolState in_play(std::string_view game, std::uint32_t down = 0) {
    PoolState state = begin_rack(*referee_of(game), 0);
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    state.down = down;
    return state;
}

inline bool pocketed_by(const PoolShot& shot, int ball) {
    return std::ranges::count(shot.pocketed, ball, &PoolShot::Pocketed::ball) > 0;
}

/// A rack of 8-ball in play, player 0 to shoot.
inline PoolState eight_ball(std::optional<PoolGroup> group, std::uint32_t down = 0) {
    PoolState state = in_play("eightball", down);
    state.group = group;
    return state;
}

/// A rack of 9-ball in play, player 0 to shoot.
inline PoolState nine_ball(std::uint32_t down = 0, bool may_push_out = false) {
    PoolState state = in_play("nineball", down);
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

inline void check(const Case& each) {
    CAPTURE(each.what);
    const PoolRuling ruling = judge(each.state, each.call, each.shot);
    CHECK(ruling.foul == each.foul);
    CHECK(ruling.next.winner == each.winner);
    CHECK((ruling.next.phase == PoolPhase::over) == each.winner.has_value());
    CHECK(ruling.next.in_hand == each.in_hand);
    CHECK(ruling.next.group == each.group);
    if (!each.winner) CHECK(ruling.next.player == each.next_player);
}

inline constexpr auto open = std::nullopt;
inline constexpr auto solids = PoolGroup::solids;
inline constexpr auto stripes = PoolGroup::stripes;
inline constexpr auto anywhere = CueInHand::anywhere;
inline constexpr auto not_in_hand = CueInHand::no;
inline const std::uint32_t all_solids = balls({1, 2, 3, 4, 5, 6, 7});
inline const std::uint32_t all_stripes = balls({9, 10, 11, 12, 13, 14, 15});

}  // namespace carom::rulings
