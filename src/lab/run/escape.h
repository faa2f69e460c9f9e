#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/scene/scene.h"

namespace carom {

/// Counts balls outside a closed outline (a closed edge, a box) in which they started.
///
/// A ball is inside if its centre is, by the even-odd rule, inside the spines of the outline's
/// capsules; so a ball that is merely pressed into a wall is inside. On a torus an
/// outline may reach across the border, so any image of the centre may be inside, up to a whole
/// torus away, as for contacts with edges. Removed balls do not count.
/// The start of a ball from an emitter is its position at the end of the tick in which it was
/// added.
class EscapeWatch {
  public:
    /// `scene` is read only in the constructor.
    explicit EscapeWatch(const Scene& scene);

    /// Records where new balls start. Pre: called after every tick.
    void note_births(const World& world);

    std::size_t escaped(const World& world) const;

  private:
    struct Outline {
        Box bounds;
        std::vector<Capsule> spines;

        bool contains(Vec2 point) const;
        /// Whether it contains the point or, on a torus, one of its images.
        bool contains(const World& world, Vec2 point) const;
    };

    std::vector<Outline> outlines_;
    // By ball number: the outlines in which it started.
    std::vector<std::vector<std::uint32_t>> start_outlines_;
};

}  // namespace carom
