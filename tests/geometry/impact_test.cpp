#include "geometry/impact.h"

#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "geometry/closest.h"

using namespace carom;

namespace {

double uniform(std::mt19937_64& engine, double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
}

// A slow oracle: the first of many small steps at which the bodies overlap, refined by bisection.
template <typename Shape>
std::optional<double> first_overlap(const Disc& disc, Vec2 velocity, const Shape& other,
                                    double horizon) {
    constexpr int steps = 20'000;
    const auto gap = [&](double t) {
        return separation(Disc{disc.center + velocity * t, disc.radius}, other);
    };
    for (int i = 1; i <= steps; ++i) {
        double high = horizon * i / steps;
        if (gap(high) >= 0.0) continue;
        double low = horizon * (i - 1) / steps;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (gap(middle) < 0.0 ? high : low) = middle;
        }
        return high;
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("a head-on impact of two discs") {
    const auto impact = first_impact(Disc{{0, 0}, 1}, {2, 0}, Disc{{10, 0}, 2}, 100.0);
    REQUIRE(impact);
    CHECK(impact->time == 3.5);
    CHECK(impact->normal == Vec2{-1, 0});
}

TEST_CASE("degenerate cases of disc and disc") {
    const Disc other{{3, 0}, 1};
    CHECK(first_impact(Disc{{1, 0}, 1}, {1, 0}, other, 1)->time == 0.0);    // touching
    CHECK(first_impact(Disc{{1.5, 0}, 1}, {1, 0}, other, 1)->time == 0.0);  // overlapping
    CHECK_FALSE(first_impact(Disc{{1.5, 0}, 1}, {-1, 0}, other, 1));        // separating
    CHECK_FALSE(first_impact(Disc{{1, 0}, 1}, {0, 1}, other, 1));           // sliding past
    CHECK_FALSE(first_impact(Disc{{0, 2}, 1}, {1, 0}, other, 100));         // grazing
    CHECK_FALSE(first_impact(Disc{{0, 0}, 1}, {0, 0}, other, 100));         // at rest
    CHECK_FALSE(first_impact(Disc{{0, 0}, 1}, {1, 0}, other, 0.999));       // too late
    CHECK_FALSE(first_impact(Disc{{3, 0}, 1}, {0, 5}, other, 1));           // same centre
}

TEST_CASE("degenerate cases of disc and capsule") {
    const Capsule wall{{0, 0}, {10, 0}, 0.5};
    CHECK(first_impact(Disc{{5, 1.5}, 1}, {1, -1}, wall, 1)->time == 0.0);  // touching
    CHECK(first_impact(Disc{{5, 1}, 1}, {1, -1}, wall, 1)->time == 0.0);    // overlapping
    CHECK_FALSE(first_impact(Disc{{5, 1}, 1}, {1, 1}, wall, 1));            // separating
    CHECK_FALSE(first_impact(Disc{{5, 1.5}, 1}, {1, 0}, wall, 100));        // sliding along
    CHECK_FALSE(first_impact(Disc{{5, 9}, 1}, {0, 0}, wall, 100));          // at rest
    CHECK_FALSE(first_impact(Disc{{-5, 1.5}, 1}, {1, 0}, wall, 100));       // grazing
    const Capsule peg{{5, 5}, {5, 5}, 0.5};                                 // start == end
    const auto on_peg = first_impact(Disc{{0, 5}, 0.5}, {2, 0}, peg, 10);
    REQUIRE(on_peg);
    CHECK(on_peg->time == 2.0);
    CHECK(on_peg->normal == Vec2{-1, 0});
    CHECK_FALSE(first_impact(Disc{{5, 0}, 1}, {0, 3}, wall, 1));  // centre on the spine
    const Capsule line{{0, 0}, {10, 0}, 0.0};                     // a thin line
    CHECK(first_impact(Disc{{5, 3}, 1}, {0, -1}, line, 10)->time == 2.0);
}

TEST_CASE("a resolved impact is not found again") {
    std::mt19937_64 engine(7);
    for (int i = 0; i < 20'000; ++i) {
        const Capsule wall{{uniform(engine, -5, 5), uniform(engine, -5, 5)},
                           {uniform(engine, -5, 5), uniform(engine, -5, 5)},
                           uniform(engine, 0, 0.5)};
        const Disc disc{{uniform(engine, -20, 20), uniform(engine, -20, 20)},
                        uniform(engine, 0.01, 2)};
        const Vec2 velocity{uniform(engine, -9, 9), uniform(engine, -9, 9)};
        const auto impact = first_impact(disc, velocity, wall, 10.0);
        if (!impact) continue;
        const Vec2 after = velocity - impact->normal * (2.0 * dot(velocity, impact->normal));
        const Disc there{disc.center + velocity * impact->time, disc.radius};
        CHECK_FALSE(first_impact(there, after, wall, 10.0));
    }
}

TEST_CASE("a disc that touches a capsule and approaches has an impact at time 0") {
    // Regression: a ball that slid down a ramp fell through it. Two ways of computing the distance
    // disagreed: one found contact, the other a gap of 1e-16.
    std::mt19937_64 engine(17);
    for (int i = 0; i < 20'000; ++i) {
        CAPTURE(i);
        const Vec2 start{uniform(engine, -50, 50), uniform(engine, -50, 50)};
        const Vec2 along =
            direction({uniform(engine, -1, 1), uniform(engine, -1, 1)}, Vec2{1.0, 0.0});
        const Capsule ramp{start, start + along * 30.0, 0.6};
        // Before the start, along the side, and beyond the end.
        const double place = uniform(engine, -5, 35);
        const Vec2 foot = start + along * std::min(std::max(place, 0.0), 30.0);
        const Vec2 up = perpendicular(along);
        const double lean = place < 0.0 ? -0.5 : place > 30.0 ? 0.5 : 0.0;
        const Vec2 normal = direction(up + along * lean, up);
        const Disc disc{foot + normal * 1.2, 0.6};
        const Vec2 velocity = along * uniform(engine, -10, 10) - normal * 20.0;
        const auto impact = first_impact(disc, velocity, ramp, 0.01);
        REQUIRE(impact);
        CHECK(impact->time < 1e-13);
        CHECK(dot(impact->normal, velocity) < 0.0);
    }
}

TEST_CASE("impacts agree with a slow oracle") {
    std::mt19937_64 engine(11);
    int found = 0;
    for (int i = 0; i < 1000; ++i) {
        const Disc disc{{uniform(engine, -9, 9), uniform(engine, -9, 9)}, uniform(engine, 0.1, 2)};
        const Vec2 velocity{uniform(engine, -9, 9), uniform(engine, -9, 9)};
        const Capsule wall{{uniform(engine, -5, 5), uniform(engine, -5, 5)},
                           {uniform(engine, -5, 5), uniform(engine, -5, 5)},
                           uniform(engine, 0, 0.5)};
        if (separation(disc, wall) <= 0.0) continue;
        const auto slow = first_overlap(disc, velocity, wall, 4.0);
        const auto fast = first_impact(disc, velocity, wall, 4.0);
        if (!slow) continue;  // the oracle may miss a grazing impact
        ++found;
        REQUIRE(fast);
        CHECK(fast->time == doctest::Approx(*slow).epsilon(1e-9));
    }
    CHECK(found > 100);
}

// The gap is convex in time, so ternary search finds its minimum.
TEST_CASE("bodies that the rejection test separates have no impact") {
    std::mt19937_64 engine(17);
    int apart = 0;
    int met = 0;
    int grazed = 0;
    for (int i = 0; i < 20'000; ++i) {
        Disc disc{{uniform(engine, -9, 9), uniform(engine, -9, 9)}, uniform(engine, 0.1, 2)};
        const Vec2 velocity{uniform(engine, -9, 9), uniform(engine, -9, 9)};
        Capsule wall{{uniform(engine, -5, 5), uniform(engine, -5, 5)},
                     {uniform(engine, -5, 5), uniform(engine, -5, 5)},
                     uniform(engine, 0, 0.5)};
        if (i % 2 == 0) wall.end = wall.start;
        if (separation(disc, wall) <= 0.0) continue;
        const double horizon = uniform(engine, 0.0, 2.0);
        const auto least_gap = [&] {
            double low = 0.0;
            double high = horizon;
            const auto gap = [&](double t) {
                return separation(Disc{disc.center + velocity * t, disc.radius}, wall);
            };
            for (int k = 0; k < 100; ++k) {
                const double first = low + (high - low) / 3;
                const double second = high - (high - low) / 3;
                (gap(first) < gap(second) ? high : low) = gap(first) < gap(second) ? second : first;
            }
            return std::min(gap(high), std::min(gap(0.0), gap(horizon)));
        };
        const double gap = least_gap();
        const Vec2 offset = disc.center - closest_point(wall.start, wall.end, disc.center);
        if (stays_apart(offset, velocity, disc.radius + wall.radius, horizon)) {
            ++apart;
            CHECK(gap > 0.0);
        }
        met += gap < 0.0;
        // Change the radius so that the disc just touches.
        if (disc.radius + gap > 0.0) {
            disc.radius += gap + 1e-9;
            ++grazed;
            CHECK_FALSE(stays_apart(offset, velocity, disc.radius + wall.radius, horizon));
        }
    }
    CHECK(apart > 5'000);
    CHECK(met > 1'000);
    CHECK(grazed > 5'000);
    CHECK_FALSE(stays_apart({3, 0}, {-1, 0}, 1.0, 4.0));
    CHECK(stays_apart({3, 0}, {-1, 0}, 1.0, 1.3));
    CHECK(stays_apart({3, 0}, {1, 0}, 1.0, 1e300));
    CHECK_FALSE(stays_apart({1, 0}, {1, 0}, 1.0, 1.0));
    CHECK_FALSE(stays_apart({3, 0}, {0, 1}, 1.0, std::numeric_limits<double>::infinity()));
}

TEST_CASE("an impact at a grazing angle of 1e-8 rad is found, on the near side") {
    // A disc approaches a wall at an angle of 1e-8 rad.
    const Capsule wall{{-1e6, 0}, {1e6, 0}, 0.0};
    const auto impact = first_impact(Disc{{0, 1 + 1e-6}, 1}, {1, -1e-8}, wall, 1e9);
    REQUIRE(impact);
    CHECK(impact->time == doctest::Approx(100.0).epsilon(1e-7));
    CHECK(impact->normal == Vec2{0, 1});
}

TEST_CASE("a translating capsule gives the impact of a resting one in its frame") {
    std::mt19937_64 engine(13);
    int found = 0;
    for (int i = 0; i < 500; ++i) {
        const Disc disc{{uniform(engine, -9, 9), uniform(engine, -9, 9)}, uniform(engine, 0.1, 2)};
        const Vec2 velocity{uniform(engine, -9, 9), uniform(engine, -9, 9)};
        const Vec2 drift{uniform(engine, -3, 3), uniform(engine, -3, 3)};
        const Capsule wall{{-3, 1}, {4, 2}, 0.25};
        const auto still = first_impact(disc, velocity - drift, wall, 2.0);
        const auto moving = first_impact(disc, velocity, wall, drift, drift, 2.0);
        if (!still) continue;
        ++found;
        REQUIRE(moving);
        CHECK(moving->time == still->time);
    }
    CHECK(found > 50);
}

TEST_CASE("a rotating capsule hits a resting disc") {
    // The far end sweeps from (4,0) to (0,4) in a second, past the disc.
    const auto impact = first_impact(Disc{{2.5, 2.5}, 0.5}, {0, 0}, Capsule{{0, 0}, {4, 0}, 0.1},
                                     {0, 0}, {-4, 4}, 1.0);
    CHECK_FALSE(impact);  // the end moves straight and misses the disc: it passes at 2.83, not 4
    const auto nearer = first_impact(Disc{{1.5, 1.5}, 0.5}, {0, 0}, Capsule{{0, 0}, {4, 0}, 0.1},
                                     {0, 0}, {-4, 4}, 1.0);
    REQUIRE(nearer);
    CHECK(nearer->time > 0.1);
    CHECK(nearer->time < 0.5);
}

// Regression: the shortest step was a share of the horizon, in which a fast disc goes further than
// its size.
TEST_CASE("a fast disc does not pass through a moving capsule") {
    std::mt19937_64 engine(17);
    for (int i = 0; i < 200; ++i) {
        const Capsule wall{{0.0, -5.0}, {0.0, 5.0}, 0.0};
        const Disc disc{{uniform(engine, -900, -1), uniform(engine, -3, 3)}, 0.05};
        const Vec2 velocity{1e5, uniform(engine, -10, 10)};
        const Vec2 drift{uniform(engine, -3, 3), uniform(engine, -3, 3)};
        const Vec2 turn{uniform(engine, -3, 3), 0.0};
        const double exact = (-disc.center.x - 0.05) / 1e5;
        for (const Vec2 more : {Vec2{}, turn}) {
            const auto impact = first_impact(disc, velocity, wall, drift, drift + more, 1.0 / 60);
            REQUIRE(impact);
            CHECK(impact->time == doctest::Approx(exact).epsilon(1e-3));
        }
    }
}
