#pragma once

#include <optional>
#include <string>

#include "carom/context/play_context.h"
#include "carom/controllers/pool_ai.h"

/// The AI player as the second player of a game of pool.
namespace carom {

class PoolOpponent {
  public:
    /// least_skill..most_skill; 0: a person plays the second player.
    void set_steadiness(int steadiness);
    int steadiness() const { return ai_ ? ai_->steadiness() : 0; }

    /// The AI player is to shoot, or to choose.
    bool is_turn(const Session& session) const;
    /// Thinks, says what it is going to shoot, and shoots; only at the latest
    /// tick, since a player who has gone back in time watches.
    void play(PlayContext& play, double seconds);
    /// Waits again before the next shot: the player has gone back.
    void hesitate() { seconds_left_ = 0.0; }
    /// What it is going to shoot, or that it still thinks.
    std::string text() const;

  private:
    std::optional<PoolAi> ai_;
    double seconds_left_ = 0.0;  ///< until it shoots, once it has decided
    std::string says_;           ///< what it shoots; empty: it thinks
};

/// The AI player as a coach: aims as it would shoot, its best shots in turn.
class PoolCoach {
  public:
    void ask() { is_asked_ = true; }
    void dismiss() { is_asked_ = false; }
    bool is_asked() const { return is_asked_; }
    /// Thinks for a while. The shot that it proposes, once; none: it still thinks. Pre: is_asked(),
    /// and the player is to shoot.
    const CandidateShot* think(const Session& session);
    /// "2 of 3: cut the 4 ...", of the last proposal.
    std::string text(const Scene& scene) const;

  private:
    std::optional<PoolAi> ai_;
    bool is_asked_ = false;
    std::size_t proposed_ = 0;  ///< which of its shots
};

}  // namespace carom
