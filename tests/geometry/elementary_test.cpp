#include "geometry/elementary.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

using namespace carom;

namespace {

// The oracle is libm in extended precision. It differs between machines, but by far less than the
// bounds.
double error_of_sine(double x) {
    const auto [sine, cosine] = sin_cos(x);
    const double a = static_cast<double>(std::fabs(sine - std::sin(static_cast<long double>(x))));
    const double b = static_cast<double>(std::fabs(cosine - std::cos(static_cast<long double>(x))));
    return std::max(a, b);
}

double relative(long double value, long double truth) {
    return static_cast<double>(std::fabs((value - truth) / truth));
}

}  // namespace

TEST_CASE("sine and cosine keep their stated bound") {
    double worst = 0.0;
    for (int i = -200'000; i <= 200'000; ++i)
        worst = std::max(worst, error_of_sine(i * 0.5000123));
    for (int i = -100'000; i <= 100'000; ++i)
        worst = std::max(worst, error_of_sine(i * 7.3e-5));
    CHECK(worst <= 2.3e-16);
}

TEST_CASE("sine and cosine of degrees are exact at right angles") {
    for (int turn = -3; turn <= 3; ++turn) {
        CHECK(sin_cos_degrees(turn * 360.0).sin == 0.0);
        CHECK(sin_cos_degrees(turn * 360.0).cos == 1.0);
        CHECK(sin_cos_degrees(turn * 360.0 + 90).sin == 1.0);
        CHECK(sin_cos_degrees(turn * 360.0 + 90).cos == 0.0);
        CHECK(sin_cos_degrees(turn * 360.0 - 90).sin == -1.0);
        CHECK(sin_cos_degrees(turn * 360.0 + 180).cos == -1.0);
        CHECK(std::signbit(sin_cos_degrees(turn * 360.0 + 180).sin) == false);
    }
    CHECK(sin_cos_degrees(30).sin == doctest::Approx(0.5).epsilon(1e-15));
    CHECK(sin_cos_degrees(135).cos == doctest::Approx(-std::sqrt(0.5)).epsilon(1e-15));
}

TEST_CASE("the exponential keeps its stated bound") {
    double worst = 0.0;
    for (int i = -70'000; i <= 70'000; ++i) {
        const double x = i * 0.00999;
        worst = std::max(worst, relative(exponential(x), std::exp(static_cast<long double>(x))));
    }
    CHECK(worst <= 4e-16);
    CHECK(exponential(0.0) == 1.0);
    CHECK(exponential(-1e6) == 0.0);
    CHECK(exponential(1e6) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the decay functions keep their stated bounds, down to 0") {
    double worst_mean = 0.0;
    double worst_ramp = 0.0;
    for (double x = 1e-9; x < 600.0; x *= 1.01) {
        const long double mean = -std::expm1(-static_cast<long double>(x)) / x;
        worst_mean = std::max(worst_mean, relative(mean_decay(x), mean));
        // Below 1/2 the closed form cancels even in extended precision, so the series is used.
        long double series = 0.0L;
        for (int n = 30; n >= 3; --n)
            series = (series + 1.0L) * (-static_cast<long double>(x) / n);
        const long double ramp = x > 0.5 ? (1.0L - mean) / x : 0.5L * (1.0L + series);
        worst_mean = std::max(worst_mean, relative(mean_decay(x), mean));
        // Below 1e-3 the closed form cancels even in extended precision, so the series is used.
        worst_ramp = std::max(worst_ramp, relative(mean_decay_ramp(x), ramp));
    }
    CHECK(worst_mean <= 1e-15);
    CHECK(worst_ramp <= 2e-15);
    CHECK(mean_decay(0.0) == 1.0);
    CHECK(mean_decay_ramp(0.0) == 0.5);
}

TEST_CASE("non-finite arguments give NaN") {
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(std::isnan(sin_cos(infinity).sin));
    CHECK(std::isnan(sin_cos_degrees(infinity).cos));
    CHECK(std::isnan(exponential(std::numeric_limits<double>::quiet_NaN())));
}
