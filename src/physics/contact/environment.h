#pragma once

#include <cstdint>
#include <vector>

#include "physics/world/world.h"

namespace carom {

/// What the pairs of the solver `contact` depend on besides the balls' reference positions, radii
/// and masses: model, classes, edges, and the impulses of the last tick. Noted at the end of a tick
/// and compared at the start of the next one, so that a solver goes on with its pairs only where it
/// would find the same ones again.
class ContactEnvironment {
  public:
    /// Notes everything but the impulses.
    void note(const World& world);
    /// Notes World::pressed, as the solver leaves it.
    void note_impulses(const World& world);
    /// Whether everything is as it was noted.
    bool is_unchanged(const World& world) const;

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
