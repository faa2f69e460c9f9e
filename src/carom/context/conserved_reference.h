#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "game/session/session.h"
#include "physics/tick/totals.h"

/// Measures the drift of energy and momentum since the last change from outside.
namespace carom {

/// The reference: energy and momentum at the moment of that change.
class ConservedReference {
  public:
    /// Makes the present the reference: a command has changed the world.
    void set(const World& world);
    /// Renews the reference where commands of a recording have been applied since the last call.
    void watch_commands(const Session& session);
    std::uint64_t tick() const { return tick_; }

    /// Relative change; none if the reference has no energy, or no momentum.
    std::optional<double> energy_drift(const Totals& sums) const;
    std::optional<double> momentum_drift(const Totals& sums) const;

  private:
    std::uint64_t tick_ = 0;
    double energy_ = 0.0;
    Vec2 momentum_;
    double momentum_scale_ = 0.0;  ///< sum of magnitudes
    std::size_t commands_watched_ = 0;
};

}  // namespace carom
