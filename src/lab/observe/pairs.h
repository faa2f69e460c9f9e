#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lab/observe/curve.h"
#include "lab/observe/region.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

namespace carom {

/// The pair distribution function g(r): the number of pairs of balls at the distance r, by the
/// number that there would be of points placed at random. A mean over the ends of all ticks of the
/// observation. r is in units of the mean diameter of the balls at its beginning.
///
/// The expected number is exact for finite n: n (n - 1) / 2 times the probability that two points
/// of the region are so far apart. That is ring area / area on a torus; in a rectangle of sides a,
/// b it has the density 2r/(ab)^2 (pi a b - 2 (a + b) r + r^2) up to the shorter side (Ghosh,
/// Random distances within a rectangle, 1951). In a rectangle g still includes what its walls do to
/// the density: for that of the bulk use a torus. No value elsewhere: see region.h.
///
/// Cost: a grid over all balls, and about 16 packing pairs a ball, in every tick.
class PairMeter {
  public:
    static constexpr double bin_width = 0.02;  ///< in diameters
    static constexpr double reach = 4.0;       ///< in diameters; less in a smaller region

    PairMeter(const Scene& scene, const World& start);

    void note_tick(const World& world);

    /// By the middle of bins; empty without a value, and before the first tick.
    Curve curve() const;

    /// g at contact: a parabola fitted to the bins from 1 to 1.2 diameters, extrapolated to 1. Only
    /// where all balls had one radius at the beginning. For hard discs of packing p Henderson's is
    /// (1 - 7p/16) / (1 - p)^2.
    std::optional<double> contact_value() const;

  private:
    double share_within(double distance) const;  // of pairs of random points

    std::optional<Region> region_;
    Box torus_;
    double diameter_ = 0.0;
    double reach_ = 0.0;  // a length
    bool is_of_one_size_ = false;
    std::vector<std::uint64_t> counts_;
    double pairs_ = 0.0;  // of all balls, summed over the ticks
};

}  // namespace carom
