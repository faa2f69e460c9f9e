#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "game/session/session.h"
#include "physics/tick/totals.h"

/// How far energy and momentum have drifted since something from outside last changed them.
namespace carom {

/// Energy and momentum at that moment.
class ConservedReference {
  public:
    /// The present becomes the reference: a command has changed the world.
    void set(const World& world);
    /// Sets it where commands of a recording have been obeyed since the last call.
    void watch_commands(const Session& session);
    std::uint64_t tick() const { return tick_; }

    /// Relative change; none where the reference has no energy, or no momentum.
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
