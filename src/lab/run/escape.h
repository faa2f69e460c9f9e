#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/scene/scene.h"

namespace carom {

/// Watches which balls are outside a closed outline (a closed edge, a box) that they started in.
///
/// Inside is judged by the even-odd rule for the ball's centre against the spines of the outline's
/// capsules, so a ball that is only pressed into a wall is still inside. Balls that are removed are
/// not counted. A ball of an emitter starts where it is at the end of the tick of its birth.
class EscapeWatch {
  public:
    /// `scene` is read here only.
    explicit EscapeWatch(const Scene& scene);

    /// Takes note of where balls start that were not there before. Pre: called after every tick.
    void note_births(const World& world);

    std::size_t escaped(const World& world) const;

  private:
    struct Spine {
        Vec2 start;
        Vec2 end;
    };
    struct Outline {
        Box bounds;
        std::vector<Spine> spines;
    };
    static bool is_inside(const Outline& outline, Vec2 point);

    std::vector<Outline> outlines_;
    // By ball number: the outlines that it started in.
    std::vector<std::vector<std::uint32_t>> homes_;
};

}  // namespace carom
