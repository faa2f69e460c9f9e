#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// The vocabulary of all pool rules: shots, calls, fouls, choices, and the state of a rack. Nothing
/// here knows the table: balls are identified by their numbers.
namespace carom {

class Referee;

/// The number of the cue ball.
inline constexpr int cue_ball = 0;

/// The two groups of 8-ball: 1 to 7, and 9 to 15.
enum class PoolGroup : std::uint8_t { solids, stripes };

/// The record of a shot.
struct PoolShot {
    struct Pocketed {
        int ball = 0;
        int pocket = 0;  ///< pockets are numbered from 0

        friend bool operator==(const Pocketed&, const Pocketed&) = default;
    };
    std::optional<int> first_hit;    ///< the first ball that the cue ball hit
    bool rail_after_hit = false;     ///< a ball hit a cushion after that
    std::uint32_t railed = 0;        ///< bit n: object ball n hit a cushion
    std::vector<Pocketed> pocketed;  ///< in order, including the cue ball
    /// The first ball lay behind the head string, and the cue ball had not crossed it.
    bool hit_behind_string = false;

    friend bool operator==(const PoolShot&, const PoolShot&) = default;
};

/// The player's call before the shot.
struct PoolCall {
    enum class Kind : std::uint8_t {
        none,      ///< nothing; in a game of called shots no ball counts then
        pot,       ///< this ball into this pocket
        safety,    ///< the turn passes whatever is pocketed
        push_out,  ///< the shot is free of the rules on first hit and cushion: see may_push_out
    };
    Kind kind = Kind::none;
    int ball = 0;
    int pocket = 0;

    friend bool operator==(const PoolCall&, const PoolCall&) = default;
};

enum class PoolFoul : std::uint8_t {
    none,
    scratch,        ///< the cue ball was pocketed
    no_hit,         ///< the cue ball hit no ball
    wrong_ball,     ///< the cue ball first hit an illegal ball
    no_rail,        ///< nothing was pocketed and no ball hit a cushion after the first hit
    weak_break,     ///< 9-ball: nothing was pocketed, and fewer than four balls hit a cushion
    time,           ///< the player did not shoot before the shot clock ran out
    behind_string,  ///< in hand behind the head string, it first hit a ball behind it: see PoolShot
    weak_opening,   ///< straight pool: nothing called, and fewer than two balls and the cue ball to
                    ///< a cushion
    wrong_pot,      ///< snooker: a ball that is not on was pocketed
    hidden,         ///< snooker: it left the opponent snookered behind the free ball
};

/// Where the cue ball may be placed before the next shot.
enum class CueInHand : std::uint8_t { no, behind_head_string, anywhere, in_d };

/// What the player whose turn it is must decide before the next shot.
enum class PoolChoice : std::uint8_t {
    take_table,   ///< shoot from the present position
    break_again,  ///< the balls are racked again, and the choosing player breaks
    let_break,    ///< the balls are racked again, and the opponent breaks
    spot_eight,   ///< the 8 is spotted, and the choosing player shoots
    return_push,  ///< the opponent must shoot: who pushed out, pocketed a wrong ball, or fouled
    replace,      ///< the balls are put back as before the shot, and the opponent shoots again
};

enum class PoolPhase : std::uint8_t { breaking, choosing, playing, over };

struct PoolOptions {
    bool nine_on_break_wins = true;
    int fouls_that_lose = 3;  ///< consecutive fouls, in games that count them; 0: never
    int points = 100;         ///< straight pool: that win the frame
    /// One-pocket: the corner pockets at the foot of the table, right and left as seen from the
    /// head.
    std::array<int, 2> foot_pockets{};
    /// So many shots in a row that pocket no object ball are a stalemate: the balls are racked
    /// again, and the player who broke breaks again. 0: never.
    int stalemate = 0;

    friend bool operator==(const PoolOptions&, const PoolOptions&) = default;
};

/// Snooker: what the striker is on.
struct SnookerTurn {
    enum class On : std::uint8_t { red, color, in_order };
    On on = On::red;
    bool is_free = false;       ///< any ball may be named as the ball on
    bool is_snookered = false;  ///< no ball on can be hit on both sides
    bool sees_one_full = true;  ///< nothing lies between the cue ball and the middle of a ball on
    CueInHand in_hand = CueInHand::in_d;
    std::uint32_t down = 0;

    friend bool operator==(const SnookerTurn&, const SnookerTurn&) = default;
};

struct SnookerState {
    SnookerTurn now;
    SnookerTurn before;    ///< the stroke that may be played again
    int misses = 0;        ///< in a row from the same place, with a ball on in full view
    bool is_miss = false;  ///< the last stroke was a miss, and a ball on was in full view
    bool is_tie = false;   ///< the scores were equal, and the black was put back

    friend bool operator==(const SnookerState&, const SnookerState&) = default;
};

/// One rack in progress. Players are 0 and 1. Made by begin_rack.
struct PoolState {
    const Referee* referee = nullptr;  ///< the rules that apply; never null after begin_rack
    PoolOptions options;
    PoolPhase phase = PoolPhase::breaking;
    int player = 0;          ///< whose turn it is, to shoot or to choose
    std::uint32_t down = 0;  ///< bit n: ball n is off the table for good
    /// 8-ball: the group of player 0; none: the table is open.
    std::optional<PoolGroup> group;
    CueInHand in_hand = CueInHand::behind_head_string;
    bool may_push_out = false;   ///< 9-ball: the shot after the break may be a push-out
    std::array<int, 2> fouls{};  ///< consecutive, by player, in games that count them
    std::array<int, 2> score{};  ///< points by player, in games that count them
    int run = 0;                 ///< points of the present turn at the table
    /// One-pocket: balls that wait to be spotted until the turn is over.
    std::uint32_t waiting = 0;
    SnookerState snooker;
    int breaker = 0;
    int idle_shots = 0;  ///< in a row, without an object ball pocketed; with PoolOptions::stalemate
    /// The options in the phase `choosing`; `take_table` comes first if it is among them.
    std::vector<PoolChoice> choices;
    std::optional<int> winner;

    friend bool operator==(const PoolState&, const PoolState&) = default;
};

/// Whether the ball is off the table for good.
bool is_down(const PoolState& state, int ball);

/// A referee's ruling on a shot, a choice, or an expired clock.
struct PoolRuling {
    PoolFoul foul = PoolFoul::none;
    int penalty = 0;          ///< points that the foul cost, or gave the opponent
    std::vector<int> respot;  ///< balls to spot, in this order; never the cue ball
    bool rerack = false;      ///< all balls are racked again: after a choice, or a stalemate
    /// Straight pool: the balls that are down are racked again, without the apex ball.
    bool rack_rest = false;
    bool put_back = false;  ///< all balls return to where they lay before the shot
    bool toss = false;      ///< a coin decides who is the next player
    PoolState next;

    friend bool operator==(const PoolRuling&, const PoolRuling&) = default;
};

/// How the cue ball lies for the player whose turn it is: which balls on it can hit.
struct PoolSight {
    /// No ball on can be hit on both sides in a straight line, because of balls that are not on.
    bool is_snookered = false;
    bool is_by_called = false;   ///< ... but one could without the ball that was called
    bool sees_one_full = false;  ///< the middle of a ball on can be hit in a straight line

    friend bool operator==(const PoolSight&, const PoolSight&) = default;
};

}  // namespace carom
