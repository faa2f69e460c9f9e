#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "game/referees/pool_state.h"

/// The rules of a game of pool, without a table: the input is the record of a shot, the output a
/// ruling.
///
/// A new game is a file beside eight_ball.cpp that derives from Referee, its row in referee.cpp,
/// and its row in level/scene/games.cpp, which has the game's name in levels and its rack.
/// Everything else asks the referee: the rack, the planner, the status line.
///
/// Source: the rules of play of the World Pool-Billiard Association (WPA) as of 2016. Two of its
/// rules need a person to judge and are left out: double hits, and balls that lie exactly on a
/// line.
namespace carom {

/// Stateless: one object serves all racks, and PoolState refers to the rules that apply.
class Referee {
  public:
    virtual ~Referee() = default;

    /// The game's name in levels: "eightball".
    virtual std::string_view game() const = 0;
    /// Identifies the game in the fingerprint of a session, so it must never change.
    virtual std::uint8_t id() const = 0;

    /// Whether the player whose turn it is may hit this ball first.
    virtual bool may_hit_first(const PoolState& state, int ball) const = 0;

    /// Why neither a pot nor a safety can be called for the next shot, as a sentence; empty if both
    /// can. Pre: the phase is breaking or playing.
    virtual std::string_view why_no_call(const PoolState& state) const = 0;

    /// Judges a shot. Pre: the phase is breaking or playing; the balls of `shot` belong to this
    /// game and were on the table.
    virtual PoolRuling judge(const PoolState& state, const PoolCall& call,
                             const PoolShot& shot) const = 0;

    /// Whether running out of time now loses the frame. Counts that foul in `next`. By default it
    /// never does.
    virtual bool loses_by_time(PoolState& next) const;

    /// The target of the player whose turn it is, in a few words: "solids, 5 left", "on the 3".
    /// Pre: the phase is not breaking.
    virtual std::string target_text(const PoolState& state) const = 0;

    /// The number of balls by which the player whose turn it is leads, for the planner; 0 in a game
    /// without such a count.
    virtual int lead(const PoolState& state) const;
};

/// The referees of all games, in the order of their ids.
std::span<const Referee* const> referees();
/// The referee of the game with this name in levels; null if it is not a game of pool.
const Referee* referee_of(std::string_view game);

/// A rack that `breaker` breaks.
PoolState begin_rack(const Referee& referee, int breaker, const PoolOptions& options = {});

/// Referee::may_hit_first by the referee of this rack.
bool may_hit_first(const PoolState& state, int ball);
/// Whether a pot or a safety can be called for the next shot.
bool may_call_shots(const PoolState& state);

/// Referee::judge by the referee of this rack, and its stalemate (PoolOptions).
PoolRuling judge(const PoolState& state, const PoolCall& call, const PoolShot& shot);

/// Whether the next foul of the player whose turn it is loses the frame, so that a warning is due.
bool is_warned(const PoolState& state);

/// Judges that the time for a shot has expired: a foul, after which the opponent has ball in hand;
/// on the break, the opponent breaks from behind the head string. A player who had to choose gets
/// the first choice, which is no foul. Pre: the phase is not over.
PoolRuling judge_time(const PoolState& state);

/// Carries out a choice. Pre: `choice` is one of state.choices.
PoolRuling choose(const PoolState& state, PoolChoice choice);

}  // namespace carom
