#pragma once

#include <cstdint>
#include <vector>

#include "physics/world/world.h"

namespace carom {

/// What the pairs of the solver `contact` depend on besides where the balls were when they were
/// found, and besides their radii and masses: kept, and compared with the world of the next tick,
/// so that only pairs that would be found again are gone on with.
class ContactScenery {
  public:
    void note(const World& world);
    /// World::pressed, as the solver leaves it.
    void note_impulses(const World& world);
    /// Whether all is as it was noted.
    bool is_that_of(const World& world) const;

  private:
    Model model_;
    std::vector<Kind> kinds_;
    std::vector<Material> materials_;
    std::vector<std::uint8_t> meets_;
    std::vector<ClassIndex> kind_;     // by ball
    std::vector<double> restitution_;  // by ball, as in World
    std::vector<CapsuleId> capsule_;
    std::vector<Capsule> shape_;        // by capsule
    std::vector<ClassIndex> material_;  // by capsule
    std::size_t pressed_ = 0;
    std::uint64_t impulses_ = 0;  // a sum over them
};

}  // namespace carom
