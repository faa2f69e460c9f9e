#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lab/observe/curve.h"
#include "physics/solver.h"
#include "physics/world/world.h"

namespace carom {

/// The largest Lyapunov exponent L, 1/s: a small difference grows as exp(L t). 1/L is the Lyapunov
/// time.
///
/// Method of two trajectories (Benettin, Galgani and Strelcyn, Physical Review A 14, 1976): a twin
/// of the world starts 1e-8 radii away, in a direction that depends on the seed alone, and runs
/// under the same solver. When the difference has grown a thousandfold, or shrunk as much, the twin
/// is set back to 1e-8 radii from the world, in the same direction. L is the sum of the logarithms
/// of the growth by the time. The difference is the root of the summed squares of those of
/// positions, in mean radii. Velocities do not count, since they differ by much while a ball has
/// had an impact in one of the two worlds only; the twin is not set back at such an instant. The
/// first growth, until the difference points to where it grows fastest, distorts a short run: begin
/// later (`from=`).
///
/// If the world is changed from outside (a command, an emitter or a sink), the twin is made again,
/// and the growth of that tick does not count. While a hand or a flipper moves an edge there is no
/// value. Limit: a solver rounds to 1e-16 of the coordinates, so a difference of 1e-8 radii has 8
/// digits, fewer far from the origin. Cost: that of the run once more.
class LyapunovMeter {
  public:
    LyapunovMeter(const SolverSettings& solver, const World& start);

    /// Forgets the growth so far, but not the direction.
    void restart_count(const World& world);
    void note_tick(const World& world);

    /// None before the first tick that counts, and when the difference has vanished.
    std::optional<double> exponent() const;
    /// None also where the exponent is not positive.
    std::optional<double> time() const;
    /// The exponent by the time at which it was taken.
    Curve curve() const { return {"t", series_.points()}; }

  private:
    struct Offset {
        Vec2 position;
        Vec2 velocity;
    };
    void begin_twin(const World& world);
    void set_twin(const World& world, double scale);
    double distance(const World& world);
    bool may_set_back(double distance) const;

    Solver solver_;
    World twin_;
    Stamps stamps_;  // of the world, when the twin was last looked at
    double radius_ = 1.0;
    double radius_time_ = 0.0;     // in which a ball moves by a radius, s; 0: none moves
    std::vector<Offset> offsets_;  // of the twin from the world, by row; set by distance()
    double growth_ = 0.0;          // sum of logarithms
    double reference_ = 0.0;       // the distance from which growth goes on
    double time_ = 0.0;            // s that count
    std::uint64_t start_tick_ = 0;
    bool has_vanished_ = false;
    Series series_;
};

}  // namespace carom
