#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "lab/run/promise.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

namespace carom {

/// Whether kinetic plus potential energy grows: see InvariantCheck (invariants.h), of which this is
/// a part.
class EnergyCheck {
  public:
    /// `reports_impulses`: the solver reports all contacts, with their impulses.
    EnergyCheck(const Promise& promise, bool reports_impulses, const World& world);

    /// Another solver's promise counts from now on, with the largest energy in play so far.
    void change_promise(const Promise& promise, bool reports_impulses, const World& world);
    /// A tick begins: notes whether it begins with dense clusters.
    void begin(const World& world);
    /// What has changed since the last tick is not the solver's doing.
    void take_over(const World& world);
    /// From now on the world's energy is the most.
    void restart(const World& world);
    /// The gain in the tick, if it is more than the promise. `are_parting`: bodies that
    /// started inside one another still are.
    std::optional<double> check(const World& world, std::span<const Contact> contacts,
                                bool are_same_balls, bool are_parting);
    /// The tick is over.
    void remember(const World& world);

  private:
    double energy_in_play(const World& world) const;
    double most_work_of_movers(const World& world, std::span<const Contact> contacts) const;

    Promise promise_;
    bool reports_impulses_ = true;
    bool is_hybrid_step_ = false;  // the tick begins with dense clusters
    double energy_ = 0.0;          // after the last tick, like the three below
    std::uint64_t tick_ = 0;
    std::uint32_t next_ball_ = 0;
    std::vector<std::pair<CapsuleId, Capsule>> moved_;  // edges of movers
    double baseline_ = 0.0;        // energy at the start, and what was added since
    double clustered_gain_ = 0.0;  // beyond baseline_, from hybrid steps
    double ground_ = 0.0;          // potential for each unit of mass, of the lowest ball
    double scale_ = 0.0;           // the largest energy in play
};

}  // namespace carom
