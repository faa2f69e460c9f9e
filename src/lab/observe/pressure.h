#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lab/observe/curve.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

namespace carom {

/// The pressure of the balls in two dimensions: force per length, mass / s^2 (N/m in a level with
/// units). Two independent measures:
///
/// - From the virial, as a mean over the time t of observation (Allen and Tildesley, Computer
///   Simulation of Liquids, 2.4, for hard discs):
///
///       P = 1/A ( <K> + 1/(2t) sum over impacts of two balls of J (r1 + r2) )
///
///   K is the kinetic energy of motion, without spin, at the ends of ticks; J the impulse, and
///   r1 + r2 the distance of the centres. A: see region.h. No value without a region. An ideal gas
///   has P A = K = N kT. Under gravity it is the mean pressure over the region. The common drift of
///   the balls, if there is one, counts as motion.
/// - On edges: the normal impulses on them per time and per length of their spines (of a peg: its
///   circumference). The impulses of both sides of an edge are added.
///
/// Counts the impacts that the solver reports (Contact). Balls that rest on others press without
/// impacts, so where gravity and losses, or cloth, let balls rest, there is no value.
class PressureMeter {
  public:
    PressureMeter(const Scene& scene, const World& start);

    void note_tick(const Scene& scene, const World& world, std::span<const Contact> contacts);

    /// None before the first tick, and where there is none (see above).
    std::optional<double> pressure() const;
    std::optional<double> pressure_on(const World& world, std::span<const CapsuleId> edges) const;
    /// The share of motion in `pressure`, P_ideal.
    std::optional<double> kinetic_part() const;
    Curve curve() const { return {"t", series_.points()}; }

  private:
    void look_at_region(const Scene& scene, const World& world);

    bool counts_all_ = true;
    std::uint64_t start_tick_ = 0;
    Stamp capsules_{};
    std::optional<double> area_;
    double time_ = 0.0;
    double motion_ = 0.0;           // integral of K / A over time
    double collisions_ = 0.0;       // sum of J (r1 + r2) / 2A
    std::vector<double> impulses_;  // by CapsuleId
    Series series_;
};

}  // namespace carom
