#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "game/referees/pool_state.h"

/// The rules of a game of pool, without a table: the input is the record of a shot, the output a
/// ruling.
///
/// A new game is a file beside eight_ball.cpp that derives from Referee, its row in referee.cpp,
/// and its row in level/scene/games.cpp, which has the game's name in levels and its rack.
/// Everything else asks the referee: the rack, the spots, the planner, the status line.
///
/// Sources: the rules of play of the World Pool-Billiard Association (WPA) as of 2016; for
/// one-pocket those of onepocket.org; for snooker those of the World Professional Billiards and
/// Snooker Association (WPBSA). Two rules need a person to judge and are left out: double hits, and
/// balls that lie exactly on a line.
namespace carom {

/// Stateless: one object serves all racks, and PoolState refers to the rules that apply. The
/// functions that are not pure have the answer of the usual game.
class Referee {
  public:
    virtual ~Referee() = default;

    /// The game's name in levels: "eightball".
    virtual std::string_view game() const = 0;
    /// Identifies the game in the fingerprint of a session, so it must never change.
    virtual std::uint8_t id() const = 0;

    // Shots.

    /// Completes the state of a new rack. By default the rack waits for its break, with the cue
    /// ball behind the head string.
    virtual void begin(PoolState& state) const;
    /// Whether the player whose turn it is may hit this ball first.
    virtual bool may_hit_first(const PoolState& state, int ball) const = 0;
    /// The only pocket in which balls count for this player. By default none: any pocket serves.
    virtual std::optional<int> pocket_of(const PoolState& state, int player) const;
    /// Whether pocketing a ball in this pocket serves the player whose turn it is.
    bool may_pocket(const PoolState& state, int pocket) const;
    /// Why a pot or a safety cannot be called for the next shot, as a sentence; empty if it can.
    /// Pre: the phase is breaking or playing; `kind` is one of the two.
    virtual std::string_view why_no_call(const PoolState& state, PoolCall::Kind kind) const = 0;

    /// Judges a shot. Pre: the phase is breaking or playing; the balls of `shot` belong to this
    /// game and were on the table.
    virtual PoolRuling judge(const PoolState& state, const PoolCall& call,
                             const PoolShot& shot) const = 0;
    /// Whether rulings depend on what the next player can hit, so that see() is to be called.
    virtual bool needs_sight() const;
    /// Completes a ruling by how the balls lie after it, before anybody decides anything.
    virtual void see(PoolRuling& ruling, const PoolState& state, const PoolSight& sight) const;

    /// Judges that the time for a shot has expired: usually a foul, after which the opponent has
    /// ball in hand; on the break, the opponent breaks. Pre: the phase is breaking or playing.
    virtual PoolRuling judge_time(const PoolState& state) const;
    /// Carries out a choice. Pre: `choice` is one of state.choices.
    virtual PoolRuling choose(const PoolState& state, PoolChoice choice) const;
    /// The state of a rack that replaces the present one in the same frame.
    virtual PoolState rack_again(const PoolState& state, int breaker) const;
    /// Whether the next foul of the player whose turn it is loses the frame, or costs much more
    /// than others, so that a warning is due. Usually by PoolState::fouls.
    virtual bool is_warned(const PoolState& state) const;

    // The table.

    /// Whether this ball returns to where the level puts it, and not to the foot spot.
    virtual bool has_own_spot(int ball) const;
    /// Whether choices may put all balls back as before the shot.
    virtual bool may_put_back() const;

    // Words.

    /// The target of the player whose turn it is, in a few words: "solids, 5 left", "on the 3".
    /// Pre: the phase is not breaking.
    virtual std::string target_text(const PoolState& state) const = 0;
    /// "the 3", "the black".
    virtual std::string ball_name(int ball) const;
    /// Whether the balls bear numbers.
    virtual bool has_numbers() const;
    /// Whether a call names the pocket too.
    virtual bool calls_pocket() const;
    /// What a player may declare before a shot, apart from a pot: "safety, or push-out"; empty:
    /// none.
    virtual std::string_view declarations() const;
    /// What the warning says: "the next foul loses".
    virtual std::string_view warning_text() const;
    /// "12:40"; empty in a game without points.
    virtual std::string score_text(const PoolState& state) const;
    /// Why the shot ended as it did, where neither the pocketed balls nor a foul tell: "the 8 fell
    /// too early"; empty where they do. `state`: after the shot of `shooter`, who had called
    /// `call`.
    virtual std::string_view reason_text(const PoolState& state, const PoolCall& call,
                                         const PoolShot& shot, int shooter) const;

    // The planner.

    /// How far the player whose turn it is leads, in balls; 0 in a game without such a count.
    virtual double lead(const PoolState& state) const;
    /// Whether the break is to burst the rack. Else it is a safety.
    virtual bool breaks_hard() const;
};

/// The referees of all games, in the order of their ids.
std::span<const Referee* const> referees();
/// The referee of the game with this name in levels; null if it is not a game of pool.
const Referee* referee_of(std::string_view game);

/// A rack that `breaker` breaks.
PoolState begin_rack(const Referee& referee, int breaker, const PoolOptions& options = {});

/// Referee::may_hit_first by the referee of this rack.
bool may_hit_first(const PoolState& state, int ball);
/// Whether a pot, or a safety, can be called for the next shot.
bool may_call(const PoolState& state, PoolCall::Kind kind);

/// Referee::judge by the referee of this rack, and its stalemate (PoolOptions).
PoolRuling judge(const PoolState& state, const PoolCall& call, const PoolShot& shot);

/// Referee::is_warned by the referee of this rack.
bool is_warned(const PoolState& state);

/// Whether the foul was also a miss, as in snooker: the opponent may then have the balls put back.
bool is_miss(const PoolState& state);

/// Referee::judge_time by the referee of this rack. A player who had to choose gets the first
/// choice, which is no foul. Pre: the phase is not over.
PoolRuling judge_time(const PoolState& state);

/// The player whose turn it is concedes: the opponent wins the frame. Pre: the phase is not over.
PoolRuling concede(const PoolState& state);

/// Referee::choose by the referee of this rack.
PoolRuling choose(const PoolState& state, PoolChoice choice);

}  // namespace carom
