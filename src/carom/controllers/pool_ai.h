#pragma once

#include <memory>
#include <vector>

#include "game/ai/planner.h"
#include "game/session/session.h"

/// carom at a pool table, as an opponent or as a coach: thinks a little in each frame, so that the
/// picture goes on. What it comes to does not depend on how the work is cut.
namespace carom {

class PoolAi {
  public:
    /// As an opponent of that steadiness, least_steadiness..most_steadiness.
    explicit PoolAi(int steadiness) : steadiness_(steadiness) {}

    int steadiness() const { return steadiness_; }

    /// Thinks about the position on, or begins; true when it has come to the end. Pre: it is a game
    /// of pool, the balls lie still, and somebody is to shoot.
    bool think(const Session& session);
    /// The best first; empty before the end.
    const std::vector<PoolThought>& thoughts() const;
    /// It has thought, or thinks, about the position as it is now.
    bool is_about(const Session& session) const;
    void forget() { thinker_.reset(); }

    /// What it does now: a choice, or its best shot as it comes out. Pre: think() was true, or the
    /// phase is choosing.
    std::vector<Command> decision(const Session& session) const;

  private:
    int steadiness_;
    std::unique_ptr<PoolThinker> thinker_;  ///< null: about nothing
    // What it thinks about.
    const Scene* scene_ = nullptr;
    std::vector<Vec2> lay_;
    PoolState rules_;
};

}  // namespace carom
