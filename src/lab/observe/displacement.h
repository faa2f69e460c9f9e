#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lab/observe/curve.h"
#include "physics/world/world.h"

namespace carom {

/// How far balls get from where they were when the observation began, and how far their velocities
/// still correlate with those at the beginning. Both are means over the balls that exist at both
/// times; there is no value if none does.
///
/// - Mean square displacement: <|r(t) - r(0)|^2>, length^2. Free balls have <v^2> t^2; where motion
///   is diffusive it grows as 4 D t.
/// - Velocity autocorrelation: <v(t) v(0)> / <v(0)^2>, a number, 1 at the start. Sums over balls,
///   so slow balls weigh little. No value if all were at rest.
///
/// On a torus the displacements of the ticks are summed, each to the nearest image. That is exact
/// while no ball covers half of the torus in a tick.
class DisplacementMeter {
  public:
    explicit DisplacementMeter(const World& start);

    void note_tick(const World& world);

    std::optional<double> msd() const { return msd_; }
    std::optional<double> vacf() const { return vacf_; }
    Curve msd_curve() const { return {"t", msd_series_.points()}; }
    Curve vacf_curve() const { return {"t", vacf_series_.points()}; }

  private:
    struct Start {
        BallId id{};
        Vec2 position;  // at the start; on a torus at the last tick
        Vec2 velocity;
        Vec2 moved;  // on a torus, up to the last tick
    };
    void measure(const World& world);

    std::uint64_t start_tick_ = 0;
    std::vector<Start> starts_;  // ascending by id
    std::optional<double> msd_;
    std::optional<double> vacf_;
    Series msd_series_;
    Series vacf_series_;
};

}  // namespace carom
