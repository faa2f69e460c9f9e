#include "geometry/conservative_advancement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <doctest/doctest.h>

using namespace carom;

namespace {

class Draws {
  public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}
    double between(double low, double high) {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return low +
               (high - low) * static_cast<double>((state_ * 0x2545f4914f6cdd1dULL) >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

constexpr double slop = 1e-14;
constexpr ToiTolerance<double> tolerance{slop, 1e-9};

// c0 + c1 t + ... + c4 t^4, with its derivatives.
struct Quartic {
    std::array<double, 5> c;

    Separation<double> at(double t) const {
        Separation<double> gap{c[4], 0.0, 0.0};
        for (int i = 3; i >= 0; --i) {
            gap.acceleration = gap.acceleration * t + 2.0 * gap.velocity;
            gap.velocity = gap.velocity * t + gap.distance;
            gap.distance = gap.distance * t + c[static_cast<std::size_t>(i)];
        }
        return gap;
    }
    // A bound on the second derivative in 0..end.
    double acceleration_bound(double end) const {
        return std::fabs(2.0 * c[2]) + 6.0 * std::fabs(c[3]) * end +
               12.0 * std::fabs(c[4]) * end * end;
    }
};

// The polynomial with these roots; the sign in front is random.
Quartic with_roots(const std::array<double, 4>& roots, double front) {
    Quartic result{{front, 0, 0, 0, 0}};
    for (std::size_t n = 0; n < 4; ++n) {
        for (std::size_t i = n + 1; i > 0; --i)
            result.c[i] = result.c[i - 1] - roots[n] * result.c[i];
        result.c[0] *= -roots[n];
    }
    return result;
}

// Dense sampling, then bisection: the first time at which the distance becomes negative.
std::optional<double> sampled_impact(const Quartic& quartic, double end, int samples) {
    double before = 0.0;
    bool was_open = quartic.c[0] > 0.0;
    for (int i = 1; i <= samples; ++i) {
        double now = end * i / samples;
        const bool is_open = quartic.at(now).distance > 0.0;
        if (was_open && !is_open) {
            for (int k = 0; k < 80; ++k) {
                const double middle = before + (now - before) / 2.0;
                (quartic.at(middle).distance > 0.0 ? before : now) = middle;
            }
            return now;
        }
        was_open = is_open;
        before = now;
    }
    return std::nullopt;
}

std::optional<double> found_impact(const Quartic& quartic, double begin, double end) {
    ToiSearch<double> search;
    return first_time_of_impact<double>([&](double t) { return quartic.at(t); }, begin, end,
                                        quartic.acceleration_bound(end), tolerance, search);
}

}  // namespace

TEST_CASE("time of impact: the first root of random quartics agrees with dense sampling") {
    Draws draws(1);
    const double end = 3.0;
    int impacts = 0;
    for (int round = 0; round < 3000; ++round) {
        CAPTURE(round);
        std::array<double, 4> roots{};
        for (double& root : roots)
            root = draws.between(-1.0, 4.0);
        std::sort(roots.begin(), roots.end());
        // Roots too close for the samples have a test of their own.
        bool is_clear = std::fabs(roots[0]) > 0.01;
        for (std::size_t i = 1; i < 4; ++i)
            is_clear &= roots[i] - roots[i - 1] > 0.01 && std::fabs(roots[i]) > 0.01;
        if (!is_clear) continue;
        const Quartic quartic = with_roots(roots, draws.between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
        // Bodies that overlap at the start and approach have an impact at once.
        const Separation<double> start = quartic.at(0.0);
        const auto found = found_impact(quartic, 0.0, end);
        if (start.distance <= 0.0 && start.velocity < -tolerance.rest_speed) {
            CHECK(found == 0.0);
            continue;
        }
        if (start.distance <= 0.0) continue;
        const auto expected = sampled_impact(quartic, end, 3000);
        REQUIRE(found.has_value() == expected.has_value());
        if (!found) continue;
        ++impacts;
        const double rate = std::fabs(quartic.at(*expected).velocity);
        CHECK(std::fabs(*found - *expected) <= 1e-15 + (slop + 3e-13) / rate);
        CHECK(quartic.at(*found).velocity < 0.0);
    }
    CHECK(impacts > 500);
}

TEST_CASE("time of impact: a resolved impact is not found again, but the next one is") {
    Draws draws(2);
    for (int round = 0; round < 2000; ++round) {
        CAPTURE(round);
        const Quartic quartic = with_roots({draws.between(0.1, 1.0), draws.between(1.2, 1.9),
                                            draws.between(2.1, 2.9), draws.between(3.1, 4.0)},
                                           1.0);
        const auto first = found_impact(quartic, 0.0, 5.0);
        REQUIRE(first.has_value());
        // After an elastic impact the bodies separate as fast as they approached.
        const Separation<double> there = quartic.at(*first);
        const Quartic after{{0.0, -there.velocity, there.acceleration / 2.0, 0.0, 0.0}};
        const auto next = found_impact(after, 0.0, 5.0);
        if (there.acceleration >= 0.0) {
            CHECK_FALSE(next.has_value());
        } else {
            const double fall = 2.0 * there.velocity / there.acceleration;
            CHECK(next.has_value() == (fall <= 5.0));
            if (next) CHECK(*next == doctest::Approx(fall).epsilon(1e-12));
        }
    }
}

TEST_CASE("time of impact: two roots are found however close, and a near miss is none") {
    Draws draws(3);
    for (int round = 0; round < 2000; ++round) {
        CAPTURE(round);
        const double middle = draws.between(0.5, 2.0);
        const double bend = draws.between(0.5, 4.0);
        const double depth = std::pow(10.0, draws.between(-12.0, -1.0));
        // bend / 2 (t - middle)^2 -+ depth.
        for (const double sign : {-1.0, 1.0}) {
            const auto separation_at = [&](double t) {
                return Separation<double>{bend / 2.0 * (t - middle) * (t - middle) + sign * depth,
                                          bend * (t - middle), bend};
            };
            ToiSearch<double> search;
            const auto found =
                first_time_of_impact<double>(separation_at, 0.0, 4.0, 0.5, tolerance, search);
            CHECK(found.has_value() == (sign < 0.0));
            const double half = std::sqrt(2.0 * depth / bend);
            if (found)
                CHECK(std::fabs(*found - (middle - half)) < 1e-14 + 10 * slop / (bend * half));
        }
    }
}

TEST_CASE("time of impact: that of a parabola is exact to rounding") {
    Draws draws(4);
    int impacts = 0;
    for (int round = 0; round < 20'000; ++round) {
        CAPTURE(round);
        const Separation<DoubleDouble> wide{
            DoubleDouble(std::pow(10.0, draws.between(-9.0, 3.0))),
            DoubleDouble(draws.between(-1.0, 1.0) * std::pow(10.0, draws.between(-3, 3))),
            DoubleDouble(draws.between(-1.0, 1.0) * std::pow(10.0, draws.between(-3, 3)))};
        const Separation<double> now{wide.distance.high, wide.velocity.high,
                                     wide.acceleration.high};
        const auto found = quadratic_time_of_impact<double>(now, tolerance);
        const auto exact =
            quadratic_time_of_impact<DoubleDouble>(wide, {DoubleDouble(slop), DoubleDouble(1e-9)});
        const double discriminant =
            now.velocity * now.velocity - 2.0 * now.acceleration * now.distance;
        // For a graze, rounding decides.
        if (std::fabs(discriminant) < 1e-9 * now.velocity * now.velocity) continue;
        REQUIRE(found.has_value() == exact.has_value());
        // No impact is allowed only if the parabola stays positive.
        CHECK(found.has_value() ==
              (now.acceleration < 0.0 || (now.velocity < 0.0 && discriminant > 0.0)));
        if (!found) continue;
        ++impacts;
        const double condition = now.velocity * now.velocity / std::fabs(discriminant) + 1.0;
        CHECK(std::fabs(*found / exact->high - 1.0) < 4e-16 * condition);
        // The residual of the root, computed in twice the precision.
        const DoubleDouble t = *exact;
        const DoubleDouble left =
            wide.distance + wide.velocity * t + wide.acceleration * t * t * DoubleDouble(0.5);
        const double terms = wide.distance.high + std::fabs((wide.velocity * t).high);
        CHECK(std::fabs(left.high) < 1e-30 * condition * terms);
        CHECK((wide.velocity + wide.acceleration * t).high < 0.0);
    }
    CHECK(impacts > 5000);
}

TEST_CASE("time of impact: touching bodies have one only while they approach") {
    const ToiTolerance<double> exact{0.0, 0.0};
    CHECK(quadratic_time_of_impact<double>({0.0, -1.0, 0.0}, exact) == 0.0);
    CHECK_FALSE(quadratic_time_of_impact<double>({0.0, 0.0, 0.0}, exact).has_value());
    CHECK_FALSE(quadratic_time_of_impact<double>({0.0, 1.0, 0.0}, exact).has_value());
    CHECK_FALSE(quadratic_time_of_impact<double>({0.0, 1.0, 1.0}, exact).has_value());
    CHECK_FALSE(quadratic_time_of_impact<double>({0.0, 0.0, 1.0}, exact).has_value());
    // Up and down again: 2 v / g.
    CHECK(quadratic_time_of_impact<double>({0.0, 3.0, -2.0}, exact) == 3.0);
    // Overlapping.
    CHECK(quadratic_time_of_impact<double>({-0.1, -1.0, 0.0}, exact) == 0.0);
    CHECK_FALSE(quadratic_time_of_impact<double>({-0.1, 1.0, 0.0}, exact).has_value());
    // Pressed together without speed: when they approach noticeably.
    CHECK(quadratic_time_of_impact<double>({0.0, 0.0, -2.0}, {0.0, 1e-3}) == 5e-4);
}

// A ball slides along an edge under drag and touches a second edge of the same direction.
TEST_CASE("time of impact: a sharp acceleration bound keeps the iterations few") {
    for (const double pressing : {0.0, 1e-17, 1e-6}) {
        CAPTURE(pressing);
        int iterations = 0;
        const auto separation_at = [&](double t) {
            ++iterations;
            Separation<double> gap{-pressing * t * t / 2.0, -pressing * t, 0.0};
            gap.acceleration_bound = pressing;
            return gap;
        };
        ToiSearch<double> search;
        const auto found =
            first_time_of_impact<double>(separation_at, 0.0, 10.0, 3.0, tolerance, search);
        CHECK(iterations < 10);
        CHECK(found.has_value() == (pressing * 10.0 > tolerance.rest_speed));
        if (found) CHECK(*found == doctest::Approx(tolerance.rest_speed / pressing));
    }
}

// Bodies that stay 1e-8 apart until they meet: far more iterations than one search may take.
TEST_CASE(
    "time of impact: a suspended search reports its progress, and finds the same when resumed") {
    const auto separation_at = [](double t) {
        const double after = t < 0.5 ? 0.0 : t - 0.5;
        return Separation<double>{1e-8 - after * after, -2.0 * after, 0.0};
    };
    ToiSearch<double> search;
    search.begin_at(0.0);
    std::optional<double> found;
    int times = 0;
    for (; times < 100; ++times) {
        search.begin_at(search.resume_time.value_or(0.0));
        const double before = search.now;
        const std::uint64_t iterations = search.iterations;
        found = first_time_of_impact<double>(separation_at, 0.0, 1.0, 1e5, tolerance, search);
        CHECK(search.iterations > iterations);
        if (found) break;
        REQUIRE(search.resume_time);
        CHECK(*search.resume_time > before);
        CHECK(*search.resume_time <= 0.5 + 1e-4);
    }
    CHECK(times > 2);
    REQUIRE(found);
    CHECK(*found == doctest::Approx(0.5 + 1e-4).epsilon(1e-6));
}

// Regression: they were taken to meet where they had started, as deep inside one another.
TEST_CASE("time of impact: bodies that get out of one another meet where they touch again") {
    const double depth = 0.05;
    const double speed = 10.0;
    const double bound = 500.0;
    const auto separation_at = [&](double t) {
        Separation<double> now{-depth + speed * t - 0.5 * bound * t * t, speed - bound * t, 0.0};
        now.acceleration_bound = bound;
        return now;
    };
    ToiSearch<double> search;
    const auto found =
        first_time_of_impact<double>(separation_at, 0.0, 1.0, bound, tolerance, search);
    REQUIRE(found);
    const double expected = (speed + std::sqrt(speed * speed - 2.0 * bound * depth)) / bound;
    CHECK(*found == doctest::Approx(expected).epsilon(1e-9));
}

// Regression: the bound would not let them out, so the search went on to where they would be as
// deep again, past the impact.
TEST_CASE("time of impact: bodies get out of one another where the bound would not let them out") {
    const double depth = 0.12;
    const double speed = 67.0;
    const double slowing = 18'000.0;
    for (const double bound : {18'000.0, 18'500.0, 20'000.0, 30'000.0, 100'000.0}) {
        CAPTURE(bound);
        const auto separation_at = [&](double t) {
            return Separation<double>{-depth + speed * t - 0.5 * slowing * t * t,
                                      speed - slowing * t, -slowing};
        };
        ToiSearch<double> search;
        const auto found =
            first_time_of_impact<double>(separation_at, 0.0, 1.0, bound, tolerance, search);
        REQUIRE(found);
        const double expected =
            (speed + std::sqrt(speed * speed - 2.0 * slowing * depth)) / slowing;
        CHECK(*found == doctest::Approx(expected).epsilon(1e-9));
    }
}

// Regression: a ball that fell along a wall, pressed on it by a slow ball beside it, sank into that
// one for as long as it fell: the acceleration across the normal raised the rest speed.
TEST_CASE("time of impact: bodies that approach below the rest speed meet once they have sunk in") {
    const ToiTolerance<double> limits{
        .slop = slop, .rest_speed = 1e-2, .sink_depth = 1e-5, .sink_speed = 1e-9};
    const double speed = 1e-3;
    const double end = 100.0;
    const auto meeting = [&](double start, double velocity, double pull) {
        const auto separation_at = [=](double t) {
            return Separation<double>{.distance = start + (velocity - 0.5 * pull * t) * t,
                                      .velocity = velocity - pull * t,
                                      .acceleration = -pull,
                                      .normal_acceleration = -pull,
                                      .relative_speed = speed,
                                      .center_distance = 1.0};
        };
        ToiSearch<double> search;
        return first_time_of_impact<double>(separation_at, 0.0, end, 1.0, limits, search);
    };
    const auto touching = meeting(0.0, -speed, 0.0);
    REQUIRE(touching);
    CHECK(*touching == doctest::Approx(limits.sink_depth / speed).epsilon(1e-6));
    // Deeper ones meet at once, but not if they are at rest or part.
    CHECK(meeting(-2e-5, -speed, 0.0) == 0.0);
    CHECK(!meeting(-2e-5, 0.0, 0.0));
    CHECK(!meeting(-2e-5, speed, 0.0));
    // Those that are pulled together slowly are as deep long before they are as fast.
    const auto pulled = meeting(0.0, 0.0, 1e-4);
    REQUIRE(pulled);
    CHECK(*pulled == doctest::Approx(std::sqrt(2.0 * limits.sink_depth / 1e-4)).epsilon(1e-6));
}
