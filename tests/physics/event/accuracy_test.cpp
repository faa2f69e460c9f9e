#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/random.h"
#include "support/sanitizers.h"

// The accuracy that the solver `event` promises, over parameters drawn from a fixed seed. The
// figures in the messages are the worst encountered.

using namespace carom;
using carom::test::has_sanitizers;

namespace {

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 31'337, RandomStream::level, who, index);
}

// Log-uniform, to base 10.
double draw_size(double low, double high, std::uint64_t who, std::uint64_t index) {
    return std::pow(10.0, draw(low, high, who, index));
}

std::size_t draw_index(std::size_t count, std::uint64_t who, std::uint64_t index) {
    return static_cast<std::size_t>(draw(0.0, static_cast<double>(count), who, index));
}

std::string text(double value) {
    char line[32];
    std::snprintf(line, sizeof line, "%.2g", value);
    return line;
}

std::uint64_t collisions(const World& world) {
    return world.ledger().ball_ball_collisions + world.ledger().ball_edge_collisions;
}

// The number of collisions of a ball of mass 100^k that moves at a light one in front of a wall.
std::uint64_t collisions_of_blocks(int k, std::uint64_t who) {
    const double speed = draw_size(-2, 2, who, 0);
    const double size = draw_size(-1, 1, who, 1);
    World world = scenes::empty();
    const double wall = draw(-3.0, 3.0, who, 2);
    world.edit_definition().rate = draw(1.0, 200.0, who, 3) * speed / size;
    add_capsule(world, {{wall, -5.0 * size}, {wall, 5.0 * size}, 0.0}, 0);
    const double light = wall + size * draw(1.5, 6.0, who, 4);
    add_ball(world, {.position = {light, 0.0}, .velocity = {}, .radius = size, .mass = 1.0});
    add_ball(world, {.position = {light + size * draw(2.5, 9.0, who, 5), 0.0},
                     .velocity = {-speed, 0.0},
                     .radius = size,
                     .mass = std::pow(100.0, k)});
    Solver solver({.kind = SolverKind::event});
    // The last collision is before the heavy ball has moved back seven times the light ball's path.
    const double end = 100.0 * size / speed;
    while (world.time() < end)
        solver.tick(world);
    return collisions(world);
}

constexpr std::uint64_t digits_of_pi[] = {3, 31, 314, 3141, 31415, 314159, 3141592, 31415926};

struct Conserved {
    double energy_drift = 0.0;
    double momentum_drift = 0.0;  ///< of the sum of magnitudes
};

double sum_of_momenta(const World& world) {
    double sum = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        sum += length(world.balls().velocity[i]) / world.balls().inverse_mass[i];
    return sum;
}

Conserved run_gas(World& world, std::uint64_t until) {
    const Totals before = totals(world);
    const double magnitude = sum_of_momenta(world);
    Solver solver({.kind = SolverKind::event});
    Conserved worst;
    while (collisions(world) < until) {
        solver.tick(world);
        const Totals now = totals(world);
        worst.energy_drift = std::max(worst.energy_drift,
                                      std::fabs(now.kinetic_energy / before.kinetic_energy - 1.0));
        worst.momentum_drift =
            std::max(worst.momentum_drift, length(now.momentum - before.momentum) / magnitude);
    }
    return worst;
}

void check_energy(std::uint64_t until, std::uint64_t seed) {
    World world = scenes::gas(1000, seed);
    const Conserved worst = run_gas(world, until);
    MESSAGE(until, " collisions of 1,000 balls: energy drifts by ", text(worst.energy_drift));
    CHECK(worst.energy_drift < 1e-12);
    CHECK(deepest_overlap(world) < 1e-11);
}

void check_momentum(std::uint64_t until, std::uint64_t seed) {
    World world = scenes::gas(1000, seed, true);
    const Conserved worst = run_gas(world, until);
    MESSAGE(until, " collisions on a torus: momentum drifts by ", text(worst.momentum_drift),
            ", energy by ", text(worst.energy_drift));
    CHECK(worst.momentum_drift < 1e-12);
    CHECK(worst.energy_drift < 1e-12);
}

// A ball that falls on a floor and bounces until it rests.
struct Bouncer {
    double restitution;
    double gravity;
    double radius;
    double height;  ///< of the gap at the start
};

struct Bounces {
    std::vector<double> times;
    Vec2 rest;
    Vec2 speed;
};

Bounces bounce(const Bouncer& bouncer, double rate, double time) {
    World world = scenes::empty();
    world.edit_definition().rate = rate;
    world.edit_definition().model.gravity = Vec2{0.0, -bouncer.gravity};
    world.edit_definition().materials[0].restitution = bouncer.restitution;
    const double wide = 4.0 * bouncer.radius;
    add_capsule(world, {{-wide, 0.0}, {wide, 0.0}, 0.0}, 0);
    world.edit_definition().model.inelastic = true;
    world.edit_balls().restitution.clear();
    add_ball(world, {.position = {0.0, bouncer.height + bouncer.radius},
                     .velocity = {},
                     .radius = bouncer.radius});
    Solver solver({.kind = SolverKind::event});
    Bounces result;
    while (world.time() < time) {
        solver.tick(world);
        for (const Contact& contact : solver.contacts())
            result.times.push_back(contact.time);
    }
    result.rest = world.balls().position[0];
    result.speed = world.balls().velocity[0];
    return result;
}

// Newton's cradle in the order of `order`: final velocities, by position in the row.
std::vector<Vec2> cradle_velocities(std::size_t count, std::size_t in, double gap, double rate,
                                    const std::vector<std::size_t>& order) {
    const World row = scenes::cradle(count, in, gap);
    World world = scenes::empty();
    world.edit_definition().rate = rate;
    for (const std::size_t place : order)
        add_ball(world, {.position = row.balls().position[place],
                         .velocity = row.balls().velocity[place]});
    Solver solver({.kind = SolverKind::event});
    while (world.time() < 12.0)
        solver.tick(world);
    std::vector<Vec2> velocities(count);
    for (std::size_t i = 0; i < count; ++i)
        velocities[order[i]] = world.balls().velocity[i];
    return velocities;
}

std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t who) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[draw_index(i, who, 100 + i)]);
    return order;
}

}  // namespace

TEST_CASE("event: two blocks and a wall count the digits of pi") {
    for (int k = 0; k <= 5; ++k) {
        CAPTURE(k);
        const int all = k < 4 ? 20 : (k == 4 ? 5 : 2);
        const int scenes = has_sanitizers ? 1 : all;
        for (int scene = 0; scene < scenes; ++scene) {
            CAPTURE(scene);
            CHECK(collisions_of_blocks(k, static_cast<std::uint64_t>(100 * k + scene)) ==
                  digits_of_pi[k]);
        }
    }
}

TEST_CASE("event: a gas of 1,000 balls keeps its energy over 100,000 collisions") {
    check_energy(100'000, 1);
}

TEST_CASE("event: a gas on a torus keeps its momentum over 100,000 collisions") {
    check_momentum(100'000, 2);
}

TEST_CASE("event: a set without walls keeps its momentum") {
    double worst = 0.0;
    for (std::uint64_t scene = 0; scene < 20; ++scene) {
        // Balls of many masses that fly towards each other, collide and separate.
        World world = scenes::empty();
        for (std::uint64_t i = 0; i < 100; ++i) {
            const Vec2 place{draw(-0.3, 0.3, scene, 4 * i) + 3.0 * static_cast<double>(i % 10),
                             draw(-0.3, 0.3, scene, 4 * i + 1) + 3.0 * static_cast<double>(i / 10)};
            add_ball(world,
                     {.position = place,
                      .velocity = (Vec2{13.5, 13.5} - place) * draw(0.1, 2, scene, 4 * i + 2),
                      .mass = draw_size(-3, 3, scene, 4 * i + 3)});
        }
        const Vec2 before = totals(world).momentum;
        const double magnitude = sum_of_momenta(world);
        Solver solver({.kind = SolverKind::event});
        for (int i = 0; i < 600; ++i)
            solver.tick(world);
        CHECK(collisions(world) > 100);
        worst = std::max(worst, length(totals(world).momentum - before) / magnitude);
    }
    MESSAGE("momentum without walls drifts by ", text(worst));
    CHECK(worst < 1e-12);
}

TEST_CASE("event: every bounce is at the instant of the closed form, then the ball rests") {
    double worst = 0.0;
    double worst_rest = 0.0;
    for (std::uint64_t scene = 0; scene < 60; scene += has_sanitizers ? 5 : 1) {
        CAPTURE(scene);
        const Bouncer bouncer{.restitution = scene < 20 ? 0.9 : draw(0.0, 0.97, scene, 0),
                              .gravity = draw(1.0, 20.0, scene, 1),
                              .radius = draw(0.05, 2.0, scene, 2),
                              .height = draw(0.1, 3.0, scene, 3)};
        CAPTURE(bouncer.restitution);
        const double e = bouncer.restitution;
        // The height as the ball's double has it.
        const double height = (bouncer.height + bouncer.radius) - bouncer.radius;
        const double first = std::sqrt(2.0 * height / bouncer.gravity);
        const double rest = first * (1.0 + e) / (1.0 - e);
        const Bounces reference = bounce(bouncer, 60.0, rest + 5.0);
        // v e^n, up to the first rebound below 1e-9 radii. Summed backwards.
        std::size_t expected = 1;
        for (double rise = height * e * e; rise >= 1e-9 * bouncer.radius; rise *= e * e)
            ++expected;
        CHECK(reference.times.size() == expected);
        double longest_after = 0.0;
        for (std::size_t n = 0; n < reference.times.size(); ++n) {
            const double power = std::pow(e, static_cast<double>(n));
            const double sum = e < 1.0 && n > 0 ? e * (1.0 - power) / (1.0 - e) : 0.0;
            const double exact = first * (1.0 + 2.0 * sum);
            worst = std::max(worst, std::fabs(reference.times[n] - exact));
            longest_after = rest - exact;
        }
        // The remaining bounces of the closed form.
        const double hop = std::sqrt(2.0 * 1e-9 * bouncer.radius / bouncer.gravity);
        CHECK(longest_after <= 2.0 * hop / (1.0 - e) * (1.0 + 1e-6));
        worst_rest = std::max(worst_rest, longest_after);
        CHECK(reference.speed == Vec2{});
        CHECK(std::fabs(reference.rest.y - bouncer.radius) < 1e-9 * bouncer.radius);
        for (const double rate : {0.7, 7.0, 120.0, 997.0, 4000.0}) {
            CAPTURE(rate);
            const Bounces other = bounce(bouncer, rate, rest + 5.0);
            CHECK(other.times == reference.times);
            CHECK(other.rest == reference.rest);
            CHECK(other.speed == Vec2{});
        }
    }
    MESSAGE("bounce times are within ", text(worst), " s of the closed form; rest begins ",
            text(worst_rest), " s before the sum of all bounces, at most");
    CHECK(worst < 1e-12);
}

TEST_CASE("event: a cradle releases as many balls as went in, whatever their order") {
    double worst = 0.0;
    std::uint64_t scene = 0;
    for (std::size_t count = 2; count <= 50; ++count)
        for (int repeat = 0; repeat < 6; ++repeat) {
            ++scene;
            const std::size_t most = std::min<std::size_t>(10, count - 1);
            const std::size_t in = repeat == 0 ? most : 1 + draw_index(most, scene, 0);
            const double gap = repeat < 3 ? 0.0 : draw_size(-12, -6, scene, 1);
            const double rate = draw_size(-1, 2.5, scene, 2);
            CAPTURE(count);
            CAPTURE(in);
            CAPTURE(gap);
            CAPTURE(rate);
            std::vector<std::size_t> order(count);
            std::iota(order.begin(), order.end(), std::size_t{0});
            const auto velocities = cradle_velocities(count, in, gap, rate, order);
            double error = 0.0;
            for (std::size_t i = 0; i < count; ++i)
                error =
                    std::max(error, length(velocities[i] - Vec2{i + in >= count ? 1.0 : 0.0, 0.0}));
            CHECK(error < 1e-12);
            worst = std::max(worst, error);
            CHECK(cradle_velocities(count, in, gap, rate, shuffled(count, scene)) == velocities);
        }
    MESSAGE("speeds of cradles are within ", text(worst));
}

TEST_SUITE("long") {
    TEST_CASE("event: a gas of 1,000 balls keeps its energy over 1,000,000 collisions") {
        check_energy(1'000'000, 3);
    }

    TEST_CASE("event: a gas on a torus keeps its momentum over 1,000,000 collisions") {
        check_momentum(1'000'000, 4);
    }

    TEST_CASE("event: two blocks and a wall count 3141592 and 31415926") {
        for (int k = 6; k <= 7; ++k) {
            CAPTURE(k);
            CHECK(collisions_of_blocks(k, static_cast<std::uint64_t>(100 * k)) == digits_of_pi[k]);
        }
    }

    // Speeds of discs have the Rayleigh distribution 1 - exp(-v^2 / 2kT). The pressure is computed
    // from the virial and compared with Henderson, A simple equation of state for hard discs,
    // Molecular Physics 30 (1975): Z = (1 + eta^2 / 8) / (1 - eta)^2.
    TEST_CASE("event: hard discs at packing 0.3 agree with the literature") {
        const std::size_t count = 1000;
        World world = scenes::gas(count, 5, true);
        // The centre of mass is at rest.
        Vec2 mean = totals(world).momentum / static_cast<double>(count);
        for (Vec2& v : world.edit_balls().velocity)
            v -= mean;
        const double temperature =
            totals(world).kinetic_energy / static_cast<double>(count - 1);  // m = 1: kT
        Solver solver({.kind = SolverKind::event});
        while (collisions(world) < 100'000)
            solver.tick(world);
        const double begin = world.time();
        double virial = 0.0;
        std::vector<double> speeds;
        std::uint64_t next = collisions(world);
        while (collisions(world) < 2'000'000) {
            solver.tick(world);
            for (const Contact& contact : solver.contacts())
                virial += contact.impulse * 2.0;  // times the distance of the centres
            if (collisions(world) < next) continue;
            next += 100'000;
            for (const Vec2 v : world.balls().velocity)
                speeds.push_back(length(v));
        }
        const double n = static_cast<double>(count);
        const double factor = 1.0 + virial / (2.0 * (world.time() - begin) * n * temperature);
        const double henderson = (1.0 + 0.3 * 0.3 / 8.0) / (0.7 * 0.7);
        std::sort(speeds.begin(), speeds.end());
        const double samples = static_cast<double>(speeds.size());
        double distance = 0.0;
        for (std::size_t i = 0; i < speeds.size(); ++i) {
            const double expected = 1.0 - std::exp(-speeds[i] * speeds[i] / (2.0 * temperature));
            distance = std::max({distance, std::fabs(expected - static_cast<double>(i) / samples),
                                 std::fabs(expected - static_cast<double>(i + 1) / samples)});
        }
        MESSAGE("Z = ", factor, ", Henderson's is ", henderson, ": ",
                text(100.0 * (factor / henderson - 1.0)), " %; Kolmogorov-Smirnov ",
                text(distance * std::sqrt(samples)), " of ", speeds.size(), " speeds");
        CHECK(std::fabs(factor / henderson - 1.0) < 0.01);
        CHECK(distance * std::sqrt(samples) < 1.63);  // the 1 % level
    }
}
