#include "lab/measure/growth.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace carom;

namespace {

std::vector<GrowthPoint> points(const std::function<double(double)>& difference) {
    std::vector<GrowthPoint> found;
    for (int i = 0; i <= 100; ++i)
        found.push_back({i * 0.1, difference(i * 0.1)});
    return found;
}

}  // namespace

TEST_CASE("the doubling time of an exponential is found, up to saturation") {
    for (const double doubling : {0.05, 0.3, 2.0}) {
        CAPTURE(doubling);
        const auto growth = exponential_growth(
            points([&](double t) { return std::min(5.0, 1e-9 * std::exp2(t / doubling)); }), 0.1);
        REQUIRE(growth.has_value());
        CHECK(growth->doubling_time == doctest::Approx(doubling));
        CHECK(growth->to < std::min(10.0, doubling * std::log2(1e8)) + 1e-9);
    }
}

TEST_CASE("fluctuations about an exponential do not change its doubling time") {
    const auto growth = exponential_growth(
        points([](double t) { return 1e-6 * std::exp2(t + 0.5 * std::sin(9 * t)); }), 1.0);
    REQUIRE(growth.has_value());
    CHECK(growth->doubling_time == doctest::Approx(1.0).epsilon(0.02));
}

TEST_CASE("a difference that starts later is timed from there") {
    const auto growth = exponential_growth(
        points([](double t) { return t < 3 ? 0.0 : 1e-6 * std::exp2((t - 3) / 0.5); }), 0.1);
    REQUIRE(growth.has_value());
    CHECK(growth->doubling_time == doctest::Approx(0.5));
    CHECK(growth->from >= 3.0);
}

TEST_CASE("no chaos in zero, steady, power-law, decaying or insufficient growth") {
    const std::function<double(double)> rows[] = {
        [](double) { return 0.0; },
        [](double) { return 1e-15; },
        [](double t) { return 1e-4 * t; },
        [](double t) { return t < 2 ? 0.0 : 1e-4 * (t - 2); },
        [](double t) { return 1e-5 * t * t; },
        [](double t) { return 1e-3 * std::exp2(-t); },
        [](double t) { return 1e-3 * std::exp2(t / 5); },
        [](double t) { return std::exp2(t / 0.02) * 1e-3; },  // saturated before it can be measured
    };
    for (const auto& difference : rows)
        CHECK_FALSE(exponential_growth(points(difference), 0.1).has_value());
    CHECK_FALSE(exponential_growth({}, 0.1).has_value());
}
