#include "geometry/closing.h"

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

constexpr double touch = 1e-14;
constexpr ClosingTolerance<double> tolerance{touch, 1e-9};

// c0 + c1 t + ... + c4 t^4, with its derivatives.
struct Quartic {
    std::array<double, 5> c;

    Gap<double> at(double t) const {
        Gap<double> gap{c[4], 0.0, 0.0};
        for (int i = 3; i >= 0; --i) {
            gap.bend = gap.bend * t + 2.0 * gap.rate;
            gap.rate = gap.rate * t + gap.gap;
            gap.gap = gap.gap * t + c[static_cast<std::size_t>(i)];
        }
        return gap;
    }
    // The largest fall of the rate in 0..end.
    double pull(double end) const {
        return std::fabs(2.0 * c[2]) + 6.0 * std::fabs(c[3]) * end +
               12.0 * std::fabs(c[4]) * end * end;
    }
};

// The polynomial that has these roots, of either sign in front.
Quartic with_roots(const std::array<double, 4>& roots, double front) {
    Quartic result{{front, 0, 0, 0, 0}};
    for (std::size_t n = 0; n < 4; ++n) {
        for (std::size_t i = n + 1; i > 0; --i)
            result.c[i] = result.c[i - 1] - roots[n] * result.c[i];
        result.c[0] *= -roots[n];
    }
    return result;
}

// From dense samples, then by halving: the first time at which the gap goes below zero.
std::optional<double> sampled_closing(const Quartic& quartic, double end, int samples) {
    double before = 0.0;
    bool was_open = quartic.c[0] > 0.0;
    for (int i = 1; i <= samples; ++i) {
        double now = end * i / samples;
        const bool is_open = quartic.at(now).gap > 0.0;
        if (was_open && !is_open) {
            for (int k = 0; k < 80; ++k) {
                const double middle = before + (now - before) / 2.0;
                (quartic.at(middle).gap > 0.0 ? before : now) = middle;
            }
            return now;
        }
        was_open = is_open;
        before = now;
    }
    return std::nullopt;
}

std::optional<double> found_closing(const Quartic& quartic, double begin, double end) {
    ClosingSearch<double> search;
    return first_closing<double>([&](double t) { return quartic.at(t); }, begin, end,
                                 quartic.pull(end), tolerance, search);
}

}  // namespace

TEST_CASE("closing: the first root of random quartics is found, as dense samples find it") {
    Draws draws(1);
    const double end = 3.0;
    int closings = 0;
    for (int round = 0; round < 3000; ++round) {
        CAPTURE(round);
        std::array<double, 4> roots{};
        for (double& root : roots)
            root = draws.between(-1.0, 4.0);
        std::sort(roots.begin(), roots.end());
        // What samples cannot tell apart is another test's.
        bool is_clear = std::fabs(roots[0]) > 0.01;
        for (std::size_t i = 1; i < 4; ++i)
            is_clear &= roots[i] - roots[i - 1] > 0.01 && std::fabs(roots[i]) > 0.01;
        if (!is_clear) continue;
        const Quartic quartic = with_roots(roots, draws.between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
        // A gap that is closed at the start and closing is an impact at once.
        const Gap<double> start = quartic.at(0.0);
        const auto found = found_closing(quartic, 0.0, end);
        if (start.gap <= 0.0 && start.rate < -tolerance.slow) {
            CHECK(found == 0.0);
            continue;
        }
        if (start.gap <= 0.0) continue;
        const auto expected = sampled_closing(quartic, end, 3000);
        REQUIRE(found.has_value() == expected.has_value());
        if (!found) continue;
        ++closings;
        const double rate = std::fabs(quartic.at(*expected).rate);
        CHECK(std::fabs(*found - *expected) <= 1e-15 + (touch + 3e-13) / rate);
        CHECK(quartic.at(*found).rate < 0.0);
    }
    CHECK(closings > 500);
}

TEST_CASE("closing: what has been found and turned is not found again, but the next one is") {
    Draws draws(2);
    for (int round = 0; round < 2000; ++round) {
        CAPTURE(round);
        const Quartic quartic = with_roots({draws.between(0.1, 1.0), draws.between(1.2, 1.9),
                                            draws.between(2.1, 2.9), draws.between(3.1, 4.0)},
                                           1.0);
        const auto first = found_closing(quartic, 0.0, 5.0);
        REQUIRE(first.has_value());
        // After the impact the gap opens from zero as fast as it closed, under the same forces.
        const Gap<double> there = quartic.at(*first);
        const Quartic after{{0.0, -there.rate, there.bend / 2.0, 0.0, 0.0}};
        const auto next = found_closing(after, 0.0, 5.0);
        if (there.bend >= 0.0) {
            CHECK_FALSE(next.has_value());
        } else {
            const double fall = 2.0 * there.rate / there.bend;
            CHECK(next.has_value() == (fall <= 5.0));
            if (next) CHECK(*next == doctest::Approx(fall).epsilon(1e-12));
        }
    }
}

TEST_CASE("closing: two roots however near each other are found, and a near miss is none") {
    Draws draws(3);
    for (int round = 0; round < 2000; ++round) {
        CAPTURE(round);
        const double middle = draws.between(0.5, 2.0);
        const double bend = draws.between(0.5, 4.0);
        const double depth = std::pow(10.0, draws.between(-12.0, -1.0));
        // bend / 2 (t - middle)^2 -+ depth.
        for (const double sign : {-1.0, 1.0}) {
            const auto look = [&](double t) {
                return Gap<double>{bend / 2.0 * (t - middle) * (t - middle) + sign * depth,
                                   bend * (t - middle), bend};
            };
            ClosingSearch<double> search;
            const auto found = first_closing<double>(look, 0.0, 4.0, 0.5, tolerance, search);
            CHECK(found.has_value() == (sign < 0.0));
            const double half = std::sqrt(2.0 * depth / bend);
            if (found)
                CHECK(std::fabs(*found - (middle - half)) < 1e-14 + 10 * touch / (bend * half));
        }
    }
}

TEST_CASE("closing: of a parabola, exact to rounding") {
    Draws draws(4);
    int closings = 0;
    for (int round = 0; round < 20'000; ++round) {
        CAPTURE(round);
        const Gap<Wide> wide{Wide(std::pow(10.0, draws.between(-9.0, 3.0))),
                             Wide(draws.between(-1.0, 1.0) * std::pow(10.0, draws.between(-3, 3))),
                             Wide(draws.between(-1.0, 1.0) * std::pow(10.0, draws.between(-3, 3)))};
        const Gap<double> now{wide.gap.high, wide.rate.high, wide.bend.high};
        const auto found = quadratic_closing<double>(now, tolerance);
        const auto exact = quadratic_closing<Wide>(wide, {Wide(touch), Wide(1e-9)});
        const double discriminant = now.rate * now.rate - 2.0 * now.bend * now.gap;
        // A graze is a matter of rounding.
        if (std::fabs(discriminant) < 1e-9 * now.rate * now.rate) continue;
        REQUIRE(found.has_value() == exact.has_value());
        // None only where the parabola stays above: it opens and bends up, or its low is above.
        CHECK(found.has_value() == (now.bend < 0.0 || (now.rate < 0.0 && discriminant > 0.0)));
        if (!found) continue;
        ++closings;
        const double condition = now.rate * now.rate / std::fabs(discriminant) + 1.0;
        CHECK(std::fabs(*found / exact->high - 1.0) < 4e-16 * condition);
        // The root, put back, in the wide numbers.
        const Wide t = *exact;
        const Wide left = wide.gap + wide.rate * t + wide.bend * t * t * Wide(0.5);
        const double terms = wide.gap.high + std::fabs((wide.rate * t).high);
        CHECK(std::fabs(left.high) < 1e-30 * condition * terms);
        CHECK((wide.rate + wide.bend * t).high < 0.0);
    }
    CHECK(closings > 5000);
}

TEST_CASE("closing: touching counts only while it closes") {
    const ClosingTolerance<double> exact{0.0, 0.0};
    CHECK(quadratic_closing<double>({0.0, -1.0, 0.0}, exact) == 0.0);
    CHECK_FALSE(quadratic_closing<double>({0.0, 0.0, 0.0}, exact).has_value());
    CHECK_FALSE(quadratic_closing<double>({0.0, 1.0, 0.0}, exact).has_value());
    CHECK_FALSE(quadratic_closing<double>({0.0, 1.0, 1.0}, exact).has_value());
    CHECK_FALSE(quadratic_closing<double>({0.0, 0.0, 1.0}, exact).has_value());
    // Up and down again: 2 v / g.
    CHECK(quadratic_closing<double>({0.0, 3.0, -2.0}, exact) == 3.0);
    // Overlapping.
    CHECK(quadratic_closing<double>({-0.1, -1.0, 0.0}, exact) == 0.0);
    CHECK_FALSE(quadratic_closing<double>({-0.1, 1.0, 0.0}, exact).has_value());
    // Pressed together without speed: once they approach noticeably.
    CHECK(quadratic_closing<double>({0.0, 0.0, -2.0}, {0.0, 1e-3}) == 5e-4);
}

// Of a ball that slides along an edge under drag and touches another that lies the same way.
TEST_CASE("closing: what is known to press no more strongly is looked at a few times") {
    for (const double pull : {0.0, 1e-17, 1e-6}) {
        CAPTURE(pull);
        int looks = 0;
        const auto look = [&](double t) {
            ++looks;
            Gap<double> gap{-pull * t * t / 2.0, -pull * t, 0.0};
            gap.pull = pull;
            return gap;
        };
        ClosingSearch<double> search;
        const auto found = first_closing<double>(look, 0.0, 10.0, 3.0, tolerance, search);
        CHECK(looks < 10);
        CHECK(found.has_value() == (pull * 10.0 > tolerance.slow));
        if (found) CHECK(*found == doctest::Approx(tolerance.slow / pull));
    }
}

// A hair apart until they meet: far more looks than a search may take.
TEST_CASE("closing: a search that is left off says how far it came, and finds the same later") {
    const auto look = [](double t) {
        const double after = t < 0.5 ? 0.0 : t - 0.5;
        return Gap<double>{1e-8 - after * after, -2.0 * after, 0.0};
    };
    ClosingSearch<double> search;
    search.begin_at(0.0);
    std::optional<double> found;
    int times = 0;
    for (; times < 100; ++times) {
        search.begin_at(search.reached.value_or(0.0));
        const double before = search.now;
        const std::uint64_t looks = search.looks;
        found = first_closing<double>(look, 0.0, 1.0, 1e5, tolerance, search);
        CHECK(search.looks > looks);
        if (found) break;
        REQUIRE(search.reached);
        CHECK(*search.reached > before);
        CHECK(*search.reached <= 0.5 + 1e-4);
    }
    CHECK(times > 2);
    REQUIRE(found);
    CHECK(*found == doctest::Approx(0.5 + 1e-4).epsilon(1e-6));
}
