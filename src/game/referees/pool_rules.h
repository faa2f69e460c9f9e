#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// The rules of 8-ball and 9-ball, without a table: what a shot did goes in, and what it means
/// comes out.
///
/// Sources: the rules of play of the World Pool-Billiard Association (WPA) as of 2016, 8-ball and
/// 9-ball. Two of its rules need a person to judge and are left out: double hits, and balls that
/// lie exactly on a line. The 9 on the break wins, or is spotted where `PoolOptions` says so, as in
/// some leagues.
namespace carom {

enum class PoolGame : std::uint8_t { eight_ball, nine_ball };
/// 1 to 7; 9 to 15.
enum class PoolGroup : std::uint8_t { solids, stripes };

/// Balls go by their numbers, 0 is the cue ball.
inline constexpr int cue_ball = 0;

/// None for the cue ball and the 8.
std::optional<PoolGroup> group_of(int ball);

/// What a shot did.
struct PoolShot {
    struct Pocketed {
        int ball = 0;
        int pocket = 0;  ///< pockets are numbered from 0

        friend bool operator==(const Pocketed&, const Pocketed&) = default;
    };
    std::optional<int> first_hit;    ///< what the cue ball met first
    bool rail_after_hit = false;     ///< some ball met a cushion after that
    std::uint32_t railed = 0;        ///< bit n: object ball n met a cushion
    std::vector<Pocketed> pocketed;  ///< in order, the cue ball too

    friend bool operator==(const PoolShot&, const PoolShot&) = default;
};

/// What the player said before the shot.
struct PoolCall {
    enum class Kind : std::uint8_t {
        none,      ///< nothing that counts: 8-ball takes it as a ball that was not called
        pot,       ///< this ball into this pocket (8-ball)
        safety,    ///< the turn passes whatever falls (8-ball)
        push_out,  ///< see PoolState::may_push_out (9-ball)
    };
    Kind kind = Kind::none;
    int ball = 0;
    int pocket = 0;

    friend bool operator==(const PoolCall&, const PoolCall&) = default;
};

enum class PoolFoul : std::uint8_t {
    none,
    scratch,     ///< the cue ball was pocketed
    no_hit,      ///< it met no ball
    wrong_ball,  ///< it met a ball first that it must not
    no_rail,     ///< nothing was pocketed and no ball met a cushion after the first hit
    weak_break,  ///< 9-ball: nothing was pocketed, and fewer than four balls met a cushion
    time,        ///< the player did not shoot in the time that there was
};

/// Where the cue ball may be put before the next shot.
enum class CueInHand : std::uint8_t { no, behind_head_string, anywhere };

/// What the player whose turn it is must decide before anyone shoots.
enum class PoolChoice : std::uint8_t {
    take_table,   ///< shoot from where the balls lie
    break_again,  ///< the balls are racked anew, and the one who chooses breaks
    let_break,    ///< they are racked anew, and the other breaks
    spot_eight,   ///< the 8 comes back on its spot, and the one who chooses goes on
    return_push,  ///< the one who pushed out must shoot
};

enum class PoolPhase : std::uint8_t { breaking, choosing, playing, over };

struct PoolOptions {
    bool nine_on_break_wins = true;
    int fouls_that_lose = 3;  ///< 9-ball: in a row; 0: never

    friend bool operator==(const PoolOptions&, const PoolOptions&) = default;
};

/// One rack in progress. Players are 0 and 1.
struct PoolState {
    PoolGame game = PoolGame::eight_ball;
    PoolOptions options;
    PoolPhase phase = PoolPhase::breaking;
    int player = 0;          ///< whose turn it is, also to choose
    std::uint32_t down = 0;  ///< bit n: ball n is off the table for good
    /// 8-ball, of player 0; none: the table is open.
    std::optional<PoolGroup> group;
    CueInHand in_hand = CueInHand::behind_head_string;
    bool may_push_out = false;
    std::array<int, 2> fouls{};  ///< in a row
    /// While choosing; `take_table` first where it is among them.
    std::vector<PoolChoice> choices;
    std::optional<int> winner;

    friend bool operator==(const PoolState&, const PoolState&) = default;
};

/// A rack that `breaker` breaks.
PoolState begin_rack(PoolGame game, int breaker, const PoolOptions& options = {});

/// None while the table is open.
std::optional<PoolGroup> group_of_player(const PoolState& state, int player);
bool is_down(const PoolState& state, int ball);
/// 9-ball: the lowest ball on the table.
int lowest_ball(const PoolState& state);
/// Whether the player may meet this ball first. On the break of 8-ball any.
bool may_hit_first(const PoolState& state, int ball);

/// What a shot came to.
struct PoolRuling {
    PoolFoul foul = PoolFoul::none;
    std::vector<int> respot;  ///< balls to put back on the foot spot, the cue ball never
    bool rerack = false;      ///< all balls are racked anew (only after a choice)
    PoolState next;

    friend bool operator==(const PoolRuling&, const PoolRuling&) = default;
};

/// Pre: the phase is breaking or playing; balls in `shot` are of this game and were on the table.
PoolRuling judge(const PoolState& state, const PoolCall& call, const PoolShot& shot);

/// The time for a shot has run out: a foul, after which the other has the ball in hand; on the
/// break, behind the head string, and breaks. Who had to choose takes the first choice, and that is
/// no foul. Pre: the phase is not over.
PoolRuling judge_time(const PoolState& state);

/// Pre: `choice` is one of state.choices.
PoolRuling choose(const PoolState& state, PoolChoice choice);

}  // namespace carom
