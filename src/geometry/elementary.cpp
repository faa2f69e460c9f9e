#include "geometry/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace carom {
namespace {

// pi/2 in three parts of at most 33 bits, so that products with integers below 2^20 are exact
// (Cody-Waite argument reduction).
constexpr double half_pi_high = 0x1.921fb544p+0;
constexpr double half_pi_middle = 0x1.0b4611a6p-34;
constexpr double half_pi_low = 0x1.3198a2e037073p-69;

constexpr double ln2_high =
    0x1.62e42feep-1;  // 32 bits: its product with the exponent of a double is exact
constexpr double ln2_low = 0x1.a39ef35793c76p-33;

// Taylor polynomials for |x| <= pi/4; the first omitted term is below 1e-19.
SinCos near_zero(double x) {
    const double y = x * x;
    double sine = 0.0;
    double cosine = 0.0;
    for (int n = 17; n >= 3; n -= 2)
        sine = (sine + 1.0) * (-y / (n * (n - 1)));
    for (int n = 18; n >= 2; n -= 2)
        cosine = (cosine + 1.0) * (-y / (n * (n - 1)));
    return {x + x * sine, 1.0 + cosine};
}

// Adds a whole number of right angles, exactly.
SinCos quarter_turns(SinCos a, std::int64_t quarters) {
    switch (quarters & 3) {
        case 0:
            return a;
        case 1:
            return {a.cos, -a.sin};
        case 2:
            return {-a.sin, -a.cos};
        default:
            return {-a.cos, a.sin};
    }
}

double two_to_the(int exponent) {  // Pre: -1022 <= exponent <= 1023
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace

SinCos sin_cos(double radians) {
    if (!std::isfinite(radians)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    double x = radians;
    // For large arguments their own rounding dominates, so reducing by the double nearest 2 pi is
    // good enough.
    if (std::fabs(x) > 1e6) x = std::fmod(x, 4 * (half_pi_high + half_pi_middle));
    const double quarters = std::floor(x * (2.0 / pi) + 0.5);
    const double rest =
        ((x - quarters * half_pi_high) - quarters * half_pi_middle) - quarters * half_pi_low;
    return quarter_turns(near_zero(rest), static_cast<std::int64_t>(quarters));
}

SinCos sin_cos_degrees(double degrees) {
    if (!std::isfinite(degrees)) return sin_cos(degrees);
    const double turn = std::fmod(degrees, 360.0);  // exact
    const double quarters = std::floor(turn / 90.0 + 0.5);
    const double rest = (turn - 90.0 * quarters) * (pi / 180.0);
    SinCos result = quarter_turns(near_zero(rest), static_cast<std::int64_t>(quarters));
    result.sin += 0.0;  // turns -0 into 0, which prints without a sign
    result.cos += 0.0;
    return result;
}

double exponential(double x) {
    if (std::isnan(x)) return x;
    if (x < -700.0) return 0.0;
    if (x > 709.0) return std::numeric_limits<double>::infinity();
    const double exponent = std::floor(x * (1.0 / 0.693147180559945309417) + 0.5);
    const double rest = (x - exponent * ln2_high) - exponent * ln2_low;
    double sum = 0.0;  // e^rest - 1, |rest| <= 0.35
    for (int n = 15; n >= 1; --n)
        sum = (sum + 1.0) * (rest / n);
    return (1.0 + sum) * two_to_the(static_cast<int>(exponent) - 1) * 2.0;
}

double mean_decay(double x) {
    if (x > 0.5) return (1.0 - exponential(-x)) / x;
    double sum = 0.0;
    for (int n = 17; n >= 2; --n)
        sum = (sum + 1.0) * (-x / n);
    return 1.0 + sum;
}

double mean_decay_ramp(double x) {
    if (x > 1.0) return (1.0 - mean_decay(x)) / x;
    double sum = 0.0;
    for (int n = 20; n >= 3; --n)
        sum = (sum + 1.0) * (-x / n);
    return 0.5 * (1.0 + sum);
}

}  // namespace carom
