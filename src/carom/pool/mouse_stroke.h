#pragma once

#include <optional>
#include <vector>

#include "game/ai/person_hand.h"
#include "geometry/vec2.h"

namespace carom {

/// A stroke with the mouse: the player pulls the cue back and pushes it through the place where it
/// started. The ball gets the speed of the hand there; a push that is not straight misses the line.
class MouseStroke {
  public:
    /// The hand at the start. `way`: where the shot goes, a unit vector. `least_pull`: shorter
    /// pulls do not strike, length. `grain`: how exactly the terminal tells places, length.
    /// `time`: s on the clock of all calls.
    MouseStroke(Vec2 at, Vec2 way, double least_pull, double grain, double time);

    /// The hand moves. The stroke once it has come through the start.
    std::optional<Stroke> move(Vec2 to, double time);
    /// How far the cue is pulled back, length, >= 0.
    double pull() const;

  private:
    struct Point {
        double along = 0.0;   ///< towards the ball; negative: pulled back
        double across = 0.0;  ///< to the left
        double time = 0.0;
    };

    Vec2 start_;
    Vec2 way_;
    double least_pull_;
    double grain_;
    std::vector<Point> push_;  ///< from where the hand turned to come forward
};

}  // namespace carom
