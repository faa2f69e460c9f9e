#pragma once

#include <optional>
#include <vector>

#include "game/ai/pinball_sight.h"
#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

namespace carom {

/// How far the demonstration player pulls the plunger: it tries pulls on copies of the game, one
/// every few ticks while the ball lies there, and takes the one whose launch wins most: the skill
/// shot, where the table has one. Launches scatter, so the neighbours of a pull count too.
class PinballPlunge {
  public:
    /// Called each tick while a ball lies on the plunger. The pull, 0..1; none: it still thinks.
    std::optional<double> think(const PinballSight& sight, const Scene& scene, const World& world,
                                const PinballState& state, const SolverSettings& settings);

  private:
    std::vector<double> gains_;
    std::optional<double> chosen_;
};

}  // namespace carom
