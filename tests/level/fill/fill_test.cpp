#include "level/fill/fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "level/support/files.h"

using namespace carom;
using namespace carom::test;

namespace {

void check_clear(const World& world) {
    std::vector<Box> boxes;
    const auto disc = [&](std::size_t i) {
        return Disc{world.balls().position[i], world.balls().radius[i]};
    };
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        boxes.push_back(bounds(disc(i)));
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        for (const Capsule& edge : world.capsules().shape) {
            if (separation(disc(i), edge) < 0.0) FAIL_CHECK("ball " << i << " is in an edge");
        }
        tree.query(boxes[i], [&](std::uint32_t k) {
            if (k < i && separation(disc(i), disc(k)) < -1e-9 * world.balls().radius[i])
                FAIL_CHECK("balls " << i << " and " << k << " overlap");
            return true;
        });
    }
}

void check_inside(const World& world, const Box& box) {
    check_clear(world);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Box around = bounds(Disc{world.balls().position[i], world.balls().radius[i]});
        const bool is_inside =
            around.low.x >= box.low.x - 1e-9 && around.low.y >= box.low.y - 1e-9 &&
            around.high.x <= box.high.x + 1e-9 && around.high.y <= box.high.y + 1e-9;
        if (!is_inside) FAIL_CHECK("ball " << i << " hangs out of the box");
    }
}

}  // namespace

TEST_CASE("fills are seeded, inside their box, and clear of obstacles") {
    const std::string lines =
        "peg at=50,50 r=20\nedge 0,80 100,90 r=2\nball big at=20,20 r=10\n"
        "fill count=100 box=0,0,100,100 r=1..3\n";
    const World a = load_clean("seed 1\n" + lines).world;
    const World b = load_clean("seed 1\n" + lines).world;
    const World c = load_clean("seed 2\n" + lines).world;
    check_inside(a, {{0, 0}, {100, 100}});
    CHECK(a.balls().position == b.balls().position);
    CHECK(a.balls().position != c.balls().position);
    CHECK(*std::ranges::min_element(a.balls().radius) >= 1.0);
    CHECK(a.balls().radius[0] == 10.0);
}

TEST_CASE("size and speed of a ball do not depend on how many follow") {
    const auto world = [](std::string_view count) {
        return load_clean("fill count=" + std::string(count) +
                          " box=0,0,300,300 r=1..3 speed=1..2\n")
            .world;
    };
    const World few = world("10");
    const World more = world("50");
    CHECK(few.balls().radius[9] == more.balls().radius[9]);
    CHECK(few.balls().velocity[9] == more.balls().velocity[9]);
}

TEST_CASE("the balls of fills are in the order of the file") {
    const World world = load_clean(
                            "ball at=-5,0 r=0.5\nfill count=3 box=0,0,9,9 r=0.5\n"
                            "ball at=-9,0 r=0.25\nfill count=2 box=20,0,29,9 r=0.5\n")
                            .world;
    CHECK(world.balls().radius == std::vector<double>{0.5, 0.5, 0.5, 0.5, 0.25, 0.5, 0.5});
}

TEST_CASE("fills reach packings from thin to dense") {
    for (const char* count : {"1", "10", "3000", "5000", "8000"}) {
        CAPTURE(count);
        // 8,000 balls of radius 1 in a square of 175: a packing of 0.82.
        const World world =
            load_clean("fill count=" + std::string(count) + " box=0,0,175,175 r=1\n").world;
        check_inside(world, {{0, 0}, {175, 175}});
    }
}

TEST_CASE("balls fill a box that they just fit") {
    CHECK(load_clean("fill count=25 box=0,0,10,10 r=1\n").world.balls().size() == 25);
    CHECK(load_clean("fill count=1 box=0,0,2,2 r=1\n").world.balls().position[0] == Vec2{1, 1});
    CHECK(load_clean("fill count=50 box=0,0,100,2 r=1\n").world.balls().size() == 50);
    CHECK(load_lines("fill count=1 box=0,0,1,1 r=1\n").diagnostics.size() == 1);
    CHECK(load_lines("peg at=5,5 r=99\nfill count=5 box=0,0,10,10 r=1e-9\n").diagnostics.size() ==
          1);
}

TEST_CASE("fills take radii over six powers of ten") {
    const World world = load_clean(
                            "fill count=20000 box=0,0,1000,1000 r=0.0001..3\n"
                            "fill count=1 box=2000,0,4000,2000 r=900\n"
                            "fill count=5000 box=2000,0,4000,2000 r=0.001\n")
                            .world;
    CHECK(world.balls().size() == 25001);
    check_clear(world);
}

TEST_CASE("speeds are fixed, from a range, or Gaussian with an exact mean square") {
    const World fixed = load_clean("fill count=2000 box=0,0,300,300 r=0.5 speed=3 v=10,0\n").world;
    Vec2 sum;
    for (const Vec2 v : fixed.balls().velocity) {
        CHECK(length(v - Vec2{10, 0}) == doctest::Approx(3));
        sum += v - Vec2{10, 0};
    }
    // The mean of 2,000 unit vectors is within 5 standard deviations, 5 / sqrt(2 * 2000).
    CHECK(length(sum) / 2000 < 3 * 5 / std::sqrt(4000.0));

    const World gas = load_clean("fill count=20000 box=0,0,900,900 r=0.5 rms=7\n").world;
    double square = 0.0;
    double fourth = 0.0;
    for (const Vec2 v : gas.balls().velocity) {
        square += length_squared(v);
        fourth += length_squared(v) * length_squared(v);
    }
    CHECK(std::sqrt(square / 20000) == doctest::Approx(7).epsilon(1e-12));
    // Two Gaussian components have <v^4> = 2 <v^2>^2; the standard error here is 0.014 of that.
    CHECK(fourth / 20000 == doctest::Approx(2 * 49 * 49).epsilon(0.07));
}

TEST_CASE("the radius may be an expression of the mass") {
    const World world =
        load_clean("let k=0.8\nfill count=500 box=0,0,200,200 m=1..6 r=sqrt(m)*k\n").world;
    double least = 9.0;
    double most = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const double mass = 1.0 / world.balls().inverse_mass[i];
        CHECK(world.balls().radius[i] == doctest::Approx(0.8 * std::sqrt(mass)));
        least = std::min(least, mass);
        most = std::max(most, mass);
    }
    CHECK(least < 1.1);
    CHECK(most > 5.9);
    CHECK(load_lines("fill count=5 box=0,0,99,99 m=1..6 r=m-3\n").diagnostics.size() == 1);
}

// Regression: a fill refused to overlap obstacles that do not collide with its balls.
TEST_CASE("a fill that does not fit may overlap obstacles that do not collide with it") {
    const auto count = [](const std::string& lines) {
        const LoadResult result = load_lines(lines);
        CAPTURE(lines);
        CHECK(result.scene.has_value());
        return result.scene ? result.scene->world.balls().size() : 0;
    };
    const std::string full = "box 0,0 10,10\nball large at=5,5 r=4.9\n";
    CHECK(count("kind ghost\ncollide ghost edge\ncollide ball edge\n" + full +
                "fill ghost count=500 box=0,0,10,10 r=1\n") == 501);
    CHECK(count("kind ghost\ncollide ghost ghost\ncollide ball edge\n" + full +
                "fill ghost count=50 box=0,0,10,10 r=0.5\n") == 51);
    CHECK(count("use overlap\n" + full + "fill count=500 box=0,0,10,10 r=1\n") == 501);
    // Balls that collide are apart, and clear of edges that collide with them.
    const auto is_refused = [](const std::string& lines) { return !load_lines(lines).scene; };
    CHECK(is_refused("kind ghost\ncollide ghost ghost\ncollide ball edge\n" + full +
                     "fill ghost count=500 box=0,0,10,10 r=1\n"));
    CHECK(
        is_refused("kind ghost\ncollide ghost edge\nedge 0,5 10,5 r=4\n"
                   "fill ghost count=5 box=0,0,10,10 r=1\n"));
    // With enough room, they are clear of everything.
    const World world = load_clean(
                            "kind ghost r=0.5\ncollide ghost edge\nbox 0,0 40,40\n"
                            "fill ghost count=100 box=0,0,40,40\n")
                            .world;
    check_clear(world);
}
