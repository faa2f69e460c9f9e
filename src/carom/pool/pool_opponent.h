#pragma once

#include <optional>
#include <string>

#include "carom/context/play_context.h"
#include "carom/pool/pool_ai.h"

/// The AI player as the second player of a game of pool.
namespace carom {

class PoolOpponent {
  public:
    /// An AI player, by number (game/ai/opponents.h); 0: a person plays the second player.
    void set(int number);
    int number() const { return ai_ ? ai_->number() : 0; }

    /// Whether it is the AI player's turn to shoot or to choose.
    bool is_turn(const Session& session) const;
    /// Plans a shot, announces it, and shoots. The AI player acts only at the latest tick, so it
    /// waits while the player rewinds.
    void play(PlayContext& play, double seconds);
    /// Restarts the pause before the next shot, after a rewind.
    void hesitate() { seconds_left_ = 0.0; }
    /// The announced shot, which the AI player is about to make; null: none.
    const CandidateShot* announced(const Session& session) const;
    /// The announced shot, or that the AI player is still planning.
    std::string text() const;

  private:
    std::optional<PoolAi> ai_;
    double seconds_left_ = 0.0;  ///< until it shoots, once it has decided
    std::string says_;           ///< the announced shot; empty: still planning
};

/// The AI player as a coach: proposes its best shots in turn.
class PoolCoach {
  public:
    void ask() { is_asked_ = true; }
    void dismiss() { is_asked_ = false; }
    bool is_asked() const { return is_asked_; }
    /// Plans for a while. Returns a proposal once; null: none yet. Pre: is_asked(), and it is the
    /// player's turn to shoot.
    const CandidateShot* think(const Session& session);
    /// "2 of 3: cut the 4 ...": the last proposal in words.
    std::string text(const Scene& scene) const;

  private:
    std::optional<PoolAi> ai_;
    bool is_asked_ = false;
    std::size_t proposed_ = 0;  ///< index of the proposed shot
};

}  // namespace carom
