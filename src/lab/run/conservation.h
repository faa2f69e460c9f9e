#pragma once

#include <cstdint>
#include <optional>

#include "physics/tick/totals.h"
#include "physics/world/world.h"

/// Watches what physics keeps, tick by tick.
namespace carom {

class ConservationWatch {
  public:
    explicit ConservationWatch(const World& start);

    /// Pre: called after every tick.
    void note(const World& world);

    /// Largest change of the energy, relative to the largest kinetic energy. Where the scene takes
    /// energy away (losses, drag, limits, sinks) only a rise counts. None where it may bring energy
    /// (emitters, hands, gravity on a torus). Infinite once something is not finite.
    std::optional<double> energy_drift() const;
    /// Largest change of the momentum, relative to the largest sum of the magnitudes. None where
    /// the scene does not keep it.
    std::optional<double> momentum_drift() const;

  private:
    enum class Energy : std::uint8_t { kept, only_falls, fed };
    Energy energy_ = Energy::kept;
    bool keeps_momentum_ = false;
    Totals start_;
    double largest_kinetic_ = 0.0;
    double largest_magnitude_ = 0.0;
    double energy_change_ = 0.0;
    double momentum_change_ = 0.0;
};

}  // namespace carom
