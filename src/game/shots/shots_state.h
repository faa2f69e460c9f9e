#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/rules/goal.h"
#include "game/rules/rule_state.h"
#include "physics/world/ids.h"

namespace carom {

/// A game of balls and shots that the level's own rules judge. Plain state: a copy together with a
/// copy of the world continues with the same bits. Balls are numbered as in the scene's world at
/// the start.
struct ShotsState {
    RuleState rules;

    struct Player {
        std::int64_t score = 0;
        std::uint32_t innings = 0;  ///< turns begun
        std::uint32_t shots = 0;
        std::uint32_t fouls = 0;

        friend bool operator==(const Player&, const Player&) = default;
    };
    std::vector<Player> players;
    std::vector<std::optional<BallId>> balls;  ///< by number; none: off the table
    std::uint32_t shots = 0;                   ///< of this game
    std::uint32_t games = 0;                   ///< finished or given up before this one

    /// The ball of the last shot, where the player chooses among several; none: the first of them
    /// that is on the table.
    std::optional<std::uint32_t> struck;
    bool is_shooting = false;
    std::uint32_t rested = 0;  ///< ticks of this shot for which all balls have lain still
    /// What the rules have decided, and what happens after `shot judged`.
    enum class Verdict : std::uint8_t { none, turn, win, lose, end };
    Verdict verdict = Verdict::none;
    bool is_over = false;
    std::optional<std::uint32_t> winner;  ///< of a game that is over; none: nobody, or a tie

    bool is_in_hand = false;       ///< the player may place the cue ball
    std::int32_t hand_place = -1;  ///< in this place of RuleBook; -1: anywhere on the table

    /// Two things that have met in this shot.
    struct Meeting {
        enum class What : std::uint8_t { balls, edge, place };
        What what = What::balls;
        std::uint32_t a = 0;  ///< a ball
        std::uint32_t b = 0;  ///< a ball of a higher number, a CapsuleId, or a place of RuleBook

        friend auto operator<=>(const Meeting&, const Meeting&) = default;
    };
    std::vector<Meeting> met;       ///< ascending
    std::vector<Meeting> touching;  ///< balls that lie at edges, until they leave them
    std::vector<Meeting> inside;    ///< balls in places, ascending

    GoalState goal;  ///< of the level

    std::int32_t look = -1;  ///< the picture shows this place of RuleBook; -1: the whole table

    std::string message;  ///< of the last shot, for the player
    bool is_foul = false;

    friend bool operator==(const ShotsState&, const ShotsState&) = default;
};

}  // namespace carom
