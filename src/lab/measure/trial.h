#pragma once

#include <functional>
#include <vector>

#include "game/replay/replay_text.h"
#include "game/session/game_state.h"
#include "lab/run/choice.h"
#include "level/scene/scene.h"
#include "physics/solver.h"

namespace carom {

/// A run of a scene under one choice, with the rules of its game and the commands of a recording.
/// At another rate than the level's, a command applies at the tick nearest to its time. Changes of
/// the solver are left out. A command that is refused, since the choice has moved the balls
/// elsewhere, is left out and counted.
class Trial {
  public:
    /// `scene` and `commands` must outlive it. Pre: commands in ascending order of ticks, which are
    /// those of the level's own rate.
    Trial(const Scene& scene, const Choice& choice, const std::vector<TimedCommand>& commands);

    const World& world() const { return world_; }
    std::span<const Contact> contacts() const { return solver_.contacts(); }
    std::uint64_t refused() const { return refused_; }

    /// A tick, then the rules and the commands that are due. Nothing of it if it is cancelled.
    TickOutcome tick(const std::function<bool()>& keep_going);

  private:
    void execute_due();

    const Scene& scene_;
    const std::vector<TimedCommand>& commands_;
    World world_;
    GameState game_;
    Solver solver_;
    std::size_t next_ = 0;
    std::uint64_t refused_ = 0;
};

}  // namespace carom
