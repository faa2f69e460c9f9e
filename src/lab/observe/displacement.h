#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/observe/curve.h"
#include "physics/world/world.h"

namespace carom {

/// How far balls get, and how far their velocities still correlate with earlier ones.
///
/// - Mean square displacement: <|r(s + t) - r(s)|^2>, length^2. Free balls have <v^2> t^2; where
///   motion is diffusive it grows as 4 D t.
/// - Velocity autocorrelation: <v(s + t) v(s)> / <v(s)^2>, a number, 1 at t = 0. Sums over balls,
///   so slow balls weigh little. No value if all were at rest.
///
/// Each is a mean over the balls that exist at both times. The curves are also means over time
/// origins s (Allen and Tildesley, Computer Simulation of Liquids, section 8.3), which is right
/// where the scene is stationary. The numbers `msd` and `vacf` are of the whole time since the
/// beginning, of which there is one.
///
/// Origins are `origin_lags` lags apart. After `lags` of them, every second lag and every second
/// origin is dropped, and the distances double, so there are at most `lags / origin_lags` origins
/// at once. What a dropped origin has contributed stays. So a short time has more origins than a
/// long one, and the longest has one. Cost: at most 16 passes over the balls for each lag.
///
/// On a torus the displacements of the ticks are summed, each to the nearest image. That is exact
/// while no ball covers half of the torus in a tick.
class DisplacementMeter {
  public:
    explicit DisplacementMeter(const World& start);

    void note_tick(const World& world);

    std::optional<double> msd() const { return whole_.msd(); }
    std::optional<double> vacf() const { return whole_.vacf(); }
    Curve msd_curve() const { return curve_of(&Sums::msd); }
    Curve vacf_curve() const { return curve_of(&Sums::vacf); }

  private:
    static constexpr std::uint64_t lags = 512;
    static constexpr std::uint64_t origin_lags = 32;

    struct Place {
        BallId id{};
        Vec2 position;  // on a torus: as if it did not wrap, since the ball was first seen
        Vec2 velocity;
    };
    struct Origin {
        std::uint64_t tick = 0;
        std::vector<Place> places;  // ascending by id
    };
    /// Over pairs of an origin and a ball.
    struct Sums {
        double squares = 0.0;
        double products = 0.0;
        double own_products = 0.0;
        double pairs = 0.0;

        void add(const Sums& more);
        std::optional<double> msd() const;
        std::optional<double> vacf() const;
    };

    void note_places(const World& world);
    void measure(const World& world);
    void halve();
    Sums since(const Origin& origin) const;
    Curve curve_of(std::optional<double> (Sums::*value)() const) const;

    double tick_length_ = 0.0;
    std::uint64_t start_tick_ = 0;
    std::uint64_t lag_ = 1;  // ticks
    std::vector<Place> now_;
    std::vector<Vec2> in_frame_;  // on a torus: beside now_, where the balls are in it
    std::vector<Origin> origins_;
    std::vector<Sums> sums_;  // by lag
    Sums whole_;
};

}  // namespace carom
