#pragma once

#include <string>

#include "game/ai/person_hand.h"
#include "terminal/canvas/palette.h"

namespace carom {

/// A stroke by keys: a mark swings across a scale, and the stroke is as good as the mark is near
/// the middle when the player strikes. It swings faster for a harder shot.
class StrokeMeter {
  public:
    /// `speed`: of the shot that the player wants; `most`: the hardest possible.
    StrokeMeter(double speed, double most);

    /// Lets the player's seconds pass.
    void pass(double seconds) { gone_ += seconds; }
    /// The place of the mark after further seconds, -1..1; 0 is the middle, and it starts at 1.
    double mark(double seconds = 0.0) const;
    /// The stroke if the player strikes after further seconds.
    Stroke strike(double seconds) const { return {speed_, mark(seconds)}; }
    /// Whether the mark has swung so often that the player has to begin again.
    bool is_over() const;

    /// "stroke ▕───────●──┼──────────▏ press enter in the middle".
    std::string text(const std::string& key, const Look& look) const;

  private:
    double speed_;
    double swing_;       ///< s from one end to the other
    double gone_ = 0.0;  ///< s
};

}  // namespace carom
