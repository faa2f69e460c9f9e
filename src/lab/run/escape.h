#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/scene/scene.h"

namespace carom {

/// Counts balls outside of a closed outline (a closed edge, a box) in which they started.
///
/// Inside is judged by the even-odd rule for the ball's centre against the spines of the outline's
/// capsules, so a ball that is merely pressed into a wall is inside. Removed balls do not count. A
/// ball of an emitter starts at its place at the end of the tick in which it was added.
class EscapeWatch {
  public:
    /// `scene` is read here only.
    explicit EscapeWatch(const Scene& scene);

    /// Notes where new balls start. Pre: called after every tick.
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
