#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <doctest/doctest.h>

#include "geometry/closest.h"
#include "physics/solver.h"
#include "physics/support/oracle.h"
#include "physics/support/scenes.h"
#include "physics/world/random.h"
#include "support/sanitizers.h"

// The solver `event` against a reference of 96 digits that shares no code with it. A chaotic scene
// amplifies every difference; the reference measures by how much, from starts that differ by 1e-30.

using namespace carom;
using carom::test::has_sanitizers;

namespace {

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 161'803, RandomStream::level, who, index);
}

// A few balls in a box with edges: pegs, thin walls and thick ones, all slanted.
World scene(std::uint64_t who) {
    World world = scenes::empty();
    world.edit_definition().rate = 64.0;  // so that the end of a tick is a double without rounding
    const bool has_gravity = who % 4 != 3;
    if (has_gravity)
        world.edit_definition().model.gravity = Vec2{draw(-3, 3, who, 0), draw(-12, -6, who, 1)};
    if (who % 2 == 1) {
        world.edit_definition().kinds[0].restitution = draw(0.85, 1.0, who, 2);
        world.edit_definition().materials[0].restitution = draw(0.85, 1.0, who, 3);
    }
    scenes::add_walls(world, {{-6, -6}, {6, 6}});
    std::uint64_t n = 10;
    for (int i = 0; i < 4; ++i) {
        const Vec2 at{draw(-4, 4, who, n), draw(-4, 4, who, n + 1)};
        const Vec2 span{draw(-3, 3, who, n + 2), draw(-3, 3, who, n + 3)};
        const double radius = draw(-0.2, 0.5, who, n + 4);
        add_capsule(world, {at, i == 0 ? at : at + span, std::max(0.0, radius)}, 0);
        n += 5;
    }
    const std::size_t count = 2 + who % 4;
    while (world.balls().size() < count) {
        const Vec2 at{draw(-5, 5, who, n), draw(-5, 5, who, n + 1)};
        const double radius = draw(0.15, 0.6, who, n + 2);
        const Vec2 velocity{draw(-6, 6, who, n + 3), draw(-6, 6, who, n + 4)};
        const double mass = draw(0.2, 4.0, who, n + 5);
        n += 6;
        bool is_free = true;
        for (const Capsule& c : world.capsules().shape)
            is_free &= distance(closest_point(c.start, c.end, at), at) > radius + c.radius + 0.05;
        for (std::size_t i = 0; i < world.balls().size(); ++i)
            is_free &=
                distance(world.balls().position[i], at) > radius + world.balls().radius[i] + 0.05;
        if (is_free)
            add_ball(world, {.position = at, .velocity = velocity, .radius = radius, .mass = mass});
    }
    return world;
}

struct Worst {
    double of_growth = 0.0;  ///< error over growth, length
    double growth = 1.0;
    double error = 0.0;
    std::size_t impacts = 0;
};

double distance_of(const many_digits::Point& a, const many_digits::Point& b) {
    const many_digits::Number x = a.x - b.x;
    const many_digits::Number y = a.y - b.y;
    return many_digits::Number(sqrt(many_digits::Number(x * x + y * y))).get_d();
}

// Runs until differences have grown by `most_growth`, or for `ticks` of 1/64 s. `floor`: the
// rounding of reading a double.
Worst compare(std::uint64_t who, bool extended, std::uint64_t ticks, double most_growth,
              double floor) {
    many_digits::use();
    World world = scene(who);
    many_digits::Oracle exact(world);
    std::vector<many_digits::Oracle> others;
    const many_digits::Number hair("1e-30");
    for (std::uint64_t k = 0; k < 3; ++k) {
        others.emplace_back(world);
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const auto some = [&](std::uint64_t n) {
                return many_digits::Number(hair * draw(-1, 1, who, 10'000 + 100 * k + 4 * i + n));
            };
            others.back().nudge(i, {some(0), some(1)}, {some(2), some(3)});
        }
    }
    Solver solver({.kind = SolverKind::event, .extended = extended});
    Worst worst;
    std::vector<Contact> contacts;
    while (world.tick() < ticks) {
        solver.tick(world);
        contacts.insert(contacts.end(), solver.contacts().begin(), solver.contacts().end());
        const many_digits::Number time(world.time());
        exact.run_until(time);
        for (auto& other : others)
            other.run_until(time);
        double error = 0.0;
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const many_digits::Point there = exact.position(i);
            for (const auto& other : others)
                worst.growth =
                    std::max(worst.growth, distance_of(there, other.position(i)) / 1e-30);
            const Vec2 p = world.balls().position[i];
            error = std::max(error, distance_of(there, {p.x, p.y}));
        }
        if (worst.growth > most_growth) break;
        worst.error = std::max(worst.error, error);
        worst.of_growth = std::max(worst.of_growth, std::max(0.0, error - floor) / worst.growth);
        REQUIRE(contacts.size() == exact.impacts().size());
        worst.impacts = contacts.size();
    }
    return worst;
}

std::string text(double value) {
    char line[32];
    std::snprintf(line, sizeof line, "%.2g", value);
    return line;
}

void check(bool extended, std::uint64_t count, std::uint64_t ticks) {
    const double most_growth = extended ? 1e18 : 1e11;
    const double floor = extended ? 4e-15 : 0.0;
    const double limit = extended ? 1e-26 : 1e-12;
    Worst worst;
    std::size_t impacts = 0;
    for (std::uint64_t who = 0; who < count; ++who) {
        CAPTURE(who);
        const Worst one = compare(who, extended, ticks, most_growth, floor);
        CHECK(one.of_growth < limit);
        worst.of_growth = std::max(worst.of_growth, one.of_growth);
        worst.growth = std::max(worst.growth, one.growth);
        worst.error = std::max(worst.error, one.error);
        impacts += one.impacts;
    }
    MESSAGE(count, " scenes, ", impacts, " impacts, growth up to ", text(worst.growth),
            ": errors up to ", text(worst.error), ", over their growth up to ",
            text(worst.of_growth));
    CHECK(impacts > 10 * count);
}

}  // namespace

TEST_CASE("oracle: a falling ball follows Galileo, and so do its bounces") {
    many_digits::use();
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0.0, -8.0};
    add_capsule(world, {{-5.0, 0.0}, {5.0, 0.0}, 0.0}, 0);
    add_ball(world, {.position = {0.5, 5.0}, .velocity = {1.0, 0.0}, .radius = 1.0});
    many_digits::Oracle exact(world);
    exact.run_until(3.5);  // falls 4 in 1 s, and bounces each 2 s
    REQUIRE(exact.impacts().size() == 2);
    CHECK(exact.impacts()[0].time == 1.0);
    CHECK(std::fabs(exact.impacts()[1].time - 3.0) < 1e-15);
    CHECK(exact.impacts()[0].b == -1);
    CHECK(std::fabs(exact.position(0).y.get_d() - 4.0) < 1e-15);
    CHECK(exact.position(0).x.get_d() == 4.0);
    // Head-on, and against a round end.
    World pair = scenes::empty();
    add_capsule(pair, {{10.0, 0.0}, {12.0, 0.0}, 0.5}, 0);
    add_ball(pair, {.position = {0.0, 0.0}, .velocity = {2.0, 0.0}, .radius = 1.0});
    add_ball(pair, {.position = {4.0, 0.0}, .velocity = {0.0, 0.0}, .radius = 0.5});
    many_digits::Oracle other(pair);
    other.run_until(4.5);
    REQUIRE(other.impacts().size() == 2);
    CHECK(other.impacts()[0].time == 1.25);
    CHECK(other.impacts()[1].time == 3.75);
    CHECK(std::fabs(other.position(1).x.get_d() - 7.5) < 1e-15);
}

TEST_CASE("event: a few balls, against 96 digits") {
    check(false, has_sanitizers ? 4 : 12, 256);
}

TEST_CASE("event with 32 digits: a few balls, against 96 digits") {
    check(true, has_sanitizers ? 1 : 3, 256);
}

TEST_SUITE("long") {
    TEST_CASE("event: a few balls for longer, against 96 digits") {
        check(false, 100, 512);
    }

    TEST_CASE("event with 32 digits: a few balls for longer, against 96 digits") {
        check(true, 40, 512);
    }
}
