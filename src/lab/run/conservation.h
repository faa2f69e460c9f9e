#pragma once

#include <cstdint>
#include <optional>

#include "physics/tick/totals.h"
#include "physics/world/world.h"

/// Monitors conserved quantities, tick by tick.
namespace carom {

class ConservationWatch {
  public:
    explicit ConservationWatch(const World& start);

    /// Pre: called after every tick.
    void note(const World& world);

    /// The largest change of the energy, relative to the largest kinetic energy. In a scene that
    /// dissipates (losses, a speed limit, sinks) only a rise counts. None in a scene that may gain
    /// energy (emitters, dragged bodies, gravity on a torus). Infinite once a number is not finite.
    std::optional<double> energy_drift() const;
    /// The largest change of the momentum, relative to the largest sum of the magnitudes. None in a
    /// scene that does not conserve it.
    std::optional<double> momentum_drift() const;

  private:
    enum class Energy : std::uint8_t { conserved, dissipated, driven };
    Energy energy_ = Energy::conserved;
    bool conserves_momentum_ = false;
    Totals start_;
    double largest_kinetic_ = 0.0;
    double largest_magnitude_ = 0.0;
    double energy_change_ = 0.0;
    double momentum_change_ = 0.0;
};

}  // namespace carom
