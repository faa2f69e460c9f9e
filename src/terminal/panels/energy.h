#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// The history of energy, momentum and drift, and plots of them.
namespace carom {

/// Some hundred samples over the whole run. When it is full, every second sample is dropped and the
/// spacing doubles.
class EnergyHistory {
  public:
    struct Sample {
        std::uint64_t tick = 0;
        double kinetic = 0.0;
        double potential = 0.0;
        double momentum = 0.0;          ///< its magnitude
        std::optional<double> drift{};  ///< of the energy, relative; none: it is not conserved
    };
    static constexpr std::size_t capacity = 512;

    /// Keeps the sample if it is due. A tick before the last is a rewind: later samples are
    /// dropped.
    void add(const Sample& sample);
    void clear();
    const std::vector<Sample>& samples() const { return samples_; }

  private:
    std::vector<Sample> samples_;  // ascending by tick, at least spacing_ apart
    std::uint64_t spacing_ = 1;
};

/// Draws into `area` kinetic, potential and total energy as three curves, with the range at the
/// side; in a tall area also momentum and, where energy is conserved, its drift, as small graphs
/// below. An area below 16 x 4 stays untouched.
void draw_energy(Canvas& canvas, const CellArea& area, const EnergyHistory& history,
                 double tick_length, const Look& look);

}  // namespace carom
