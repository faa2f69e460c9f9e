#pragma once

#include <memory>
#include <vector>

#include "game/ai/planner.h"
#include "game/session/session.h"

/// The AI player at a pool table, as an opponent or as a coach. It thinks for a while in each
/// frame, so that the picture stays smooth. Its decision does not depend on how the work is
/// divided.
namespace carom {

class PoolAi {
  public:
    /// `steadiness`: how well it holds the cue, least_skill..most_skill.
    explicit PoolAi(int steadiness) : steadiness_(steadiness) {}

    int steadiness() const { return steadiness_; }

    /// Goes on thinking about the position, or starts; true when it has decided. Pre: a game of
    /// pool is played, the balls lie still, and a shot is due.
    bool think(const Session& session);
    /// The best shots, the best first; empty before it has decided.
    const std::vector<CandidateShot>& thoughts() const;
    /// Its thoughts are about the present position.
    bool is_about(const Session& session) const;
    void forget() { thinker_.reset(); }

    /// The commands of its turn: a choice, or its best shot with the error of its hand. Pre:
    /// think() was true, or the phase is choosing.
    std::vector<Command> decision(const Session& session) const;

  private:
    int steadiness_;
    std::unique_ptr<ShotPlanner> thinker_;  ///< null: none yet
    // The position that it thinks about.
    const Scene* scene_ = nullptr;
    std::vector<Vec2> lay_;
    PoolState rules_;
};

}  // namespace carom
