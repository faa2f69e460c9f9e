#pragma once

/// The elementary functions of the deterministic core. They use + - * / and comparisons only, so
/// their results have the same bits on every machine; libm's differ between libraries.
namespace carom {

inline constexpr double pi = 3.14159265358979323846;

struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

/// Error: at most 1 unit in the last place of 1 (2.3e-16) for |radians| <= 1e5; beyond that the
/// argument's own rounding dominates. Gives NaN for an argument that is not finite.
SinCos sin_cos(double radians);

/// Sine and cosine of an angle in degrees; exact at multiples of 90 degrees.
SinCos sin_cos_degrees(double degrees);

/// e^x with a relative error of at most 4e-16 for -700 <= x <= 700; 0 below, infinity above.
double exponential(double x);

/// (1 - e^-x) / x, the mean of e^-xs over s in 0..1, without cancellation near 0. 1 at x = 0. Pre:
/// x >= 0. Relative error at most 1e-15.
double mean_decay(double x);

/// (1 - mean_decay(x)) / x without cancellation; 1/2 at x = 0. The displacement that a constant
/// force adds under drag is proportional to it. Pre: x >= 0. Relative error at most 2e-15.
double mean_decay_ramp(double x);

}  // namespace carom
