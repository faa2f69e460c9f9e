#pragma once

#include <memory>
#include <vector>

#include "game/ai/planner.h"
#include "game/session/session.h"

/// The AI player at a pool table, as an opponent or as a coach. It works for some milliseconds in
/// each frame, so that the picture stays smooth. Its decision does not depend on how the work is
/// divided.
namespace carom {

class PoolAi {
  public:
    /// `number`: of an AI player (game/ai/opponents.h).
    explicit PoolAi(int number) : number_(number) {}

    int number() const { return number_; }

    /// Starts or continues planning for the present position; true when it has decided. Pre: a game
    /// of pool is played, the balls are at rest, and a shot is due.
    bool think(const Session& session);
    /// The best shots found, the best first; empty until it has decided.
    const std::vector<CandidateShot>& candidates() const;
    /// Whether the candidates are for the present position.
    bool is_about(const Session& session) const;
    void forget() { planner_.reset(); }

    /// The commands of its turn: a choice, or its best shot with the error that its hand implies.
    /// Pre: think() was true, or the phase is choosing.
    std::vector<Command> decision(const Session& session) const;

  private:
    int number_;
    std::unique_ptr<ShotPlanner> planner_;  ///< null: not started
    // The position that is being planned for.
    const Scene* scene_ = nullptr;
    std::vector<Vec2> positions_;
    PoolState rules_;
};

}  // namespace carom
