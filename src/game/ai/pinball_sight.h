#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// A pinball table as its player sees it: where balls are lost, which flippers hold one, and what
/// is worth playing for.
namespace carom {

class PinballSight {
  public:
    /// Keeps a reference to the scene.
    explicit PinballSight(const Scene& scene);

    /// Whether the table has two flippers between which balls drain. All functions below need it.
    bool has_pair() const { return has_pair_; }
    /// Whether a ball is so low that the flippers must soon deal with it.
    bool is_near(const World& world, std::size_t ball) const;
    /// Whether a ball has fallen past the lower flippers, between or beside them.
    bool is_lost(const World& world, std::size_t ball) const;
    /// Whether a ball lies beside the lower flippers, where it depends on the lanes whether it
    /// rolls to a flipper or is lost.
    bool is_beside(const World& world, std::size_t ball) const;
    /// The raised flipper in whose cradle the ball lies, slower than `speed`, in radii a second.
    std::optional<std::size_t> cradle_of(const World& world, std::size_t ball, double speed) const;
    /// The button of the lower flipper on the ball's side of the middle.
    Button button_for(const World& world, std::size_t ball) const;
    Button button_of(std::size_t flipper) const { return scene_->table.flipper_buttons[flipper]; }

    /// What the game is worth as it stands, in points: the score, and how far its goals are
    /// reached.
    double worth(const PinballState& state) const;
    /// What the places of the balls are worth, a number: about 50 for each that is held, -100 for
    /// each that is lost.
    double safety(const World& world, const PinballState& state) const;

  private:
    bool is_outside_pivots(Vec2 at) const;
    double safety_of(const World& world, const PinballState& state, std::size_t ball) const;

    const Scene* scene_;
    bool has_pair_ = false;
    std::size_t left_ = 0;  ///< the lower flippers, as indices into World::flippers
    std::size_t right_ = 0;
    Vec2 left_pivot_;
    Vec2 right_pivot_;
    double tips_ = 0.0;  ///< height of the lower tip at rest
    double radius_ = 1.0;
};

}  // namespace carom
