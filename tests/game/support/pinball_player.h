#pragma once

#include "game/game_state.h"
#include "game/pinball.h"
#include "physics/solver.h"

/// A table that is played without a screen, by a player who flips at what comes near.
namespace carom::test {

class PinballPlayer {
  public:
    PinballPlayer(Scene scene, const SolverSettings& solver);

    /// One tick: looks, presses, computes, follows the rules.
    void tick();

    /// Another game. Pre: this one is over.
    void again();

    const Scene& scene() const { return scene_; }
    const World& world() const { return world_; }
    const PinballState& state() const { return std::get<PinballState>(game_); }
    std::uint64_t fingerprint() const { return carom::fingerprint(world_, game_); }

  private:
    void press(Button button, bool is_down);
    bool is_chance(const Flipper& flipper) const;

    Scene scene_;
    World world_;
    GameState game_;
    Solver solver_;
    std::uint64_t flip_until_[2] = {0, 0};
};

}  // namespace carom::test
