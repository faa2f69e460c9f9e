#include "physics/event/impact/lasting_impact.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "geometry/elementary.h"
#include "physics/solver.h"
#include "physics/support/cloth_table.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/random.h"

using namespace carom;

namespace {

using scenes::break_shot;
using scenes::pool_ball;

constexpr double ball_mass = 0.17;
// Phenolic resin: Young's modulus 5.84 GPa, Poisson's ratio 0.34.
constexpr double phenolic = 5.84e9 / (1.0 - 0.34 * 0.34);

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 161'803, RandomStream::level, who, index);
}

void run(World& world, double seconds, double rate = 240.0) {
    world.edit_definition().rate = rate;
    Solver solver({.kind = SolverKind::event});
    const auto ticks = static_cast<int>(seconds * rate + 0.5);
    for (int i = 0; i < ticks; ++i)
        REQUIRE(solver.tick(world) == TickOutcome::done);
}

World free_flight(double restitution) {
    World world = scenes::empty();
    world.edit_definition().model.inelastic = restitution < 1.0;
    world.edit_definition().model.modulus = phenolic;
    return world;
}

void put(World& world, Vec2 position, Vec2 velocity, double restitution) {
    add_ball(world, {.position = position,
                     .velocity = velocity,
                     .radius = pool_ball,
                     .mass = ball_mass,
                     .restitution = restitution});
}

// Fifteen balls with gaps between 0.5 and 1.5 of `gap`, and a cue ball, without cloth or edges.
World rack(double speed, double gap, double restitution, std::uint64_t seed) {
    World world = free_flight(restitution);
    put(world, {-0.1, draw(-0.005, 0.005, seed, 0)}, {speed, 0.0}, restitution);
    const double pitch = 2.0 * pool_ball + gap;
    std::uint64_t n = 1;
    for (int row = 0; row < 5; ++row)
        for (int place = 0; place <= row; ++place) {
            const Vec2 shake{draw(-0.17, 0.17, seed, n), draw(-0.17, 0.17, seed, n + 1)};
            n += 2;
            put(world,
                Vec2{row * pitch * std::sqrt(0.75), (place - 0.5 * row) * pitch} + shake * gap, {},
                restitution);
        }
    return world;
}

// The balls of a world as points with Hertz's springs between them: true positions, normals that
// turn, and steps of a thousandth of a contact. It shares nothing with the solver.
class SlowModel {
  public:
    SlowModel(const World& world, double restitution)
        : x_(world.balls().position),
          v_(world.balls().velocity),
          force_(x_.size()),
          unloading_(restitution * restitution) {}

    void run(double seconds) {
        constexpr double step = 2.5e-7;
        const double half = 0.5 * step / ball_mass;
        find_forces();
        for (auto left = static_cast<int>(seconds / step + 0.5); left > 0; --left) {
            for (std::size_t i = 0; i < x_.size(); ++i) {
                v_[i] += force_[i] * half;
                x_[i] += v_[i] * step;
            }
            find_forces();
            for (std::size_t i = 0; i < x_.size(); ++i)
                v_[i] += force_[i] * half;
        }
    }

    const std::vector<Vec2>& positions() const { return x_; }
    const std::vector<Vec2>& velocities() const { return v_; }

  private:
    void find_forces() {
        const double stiffness = 2.0 / 3.0 * phenolic * std::sqrt(0.5 * pool_ball);
        std::ranges::fill(force_, Vec2{});
        for (std::size_t i = 0; i < x_.size(); ++i)
            for (std::size_t j = i + 1; j < x_.size(); ++j) {
                const Vec2 offset = x_[i] - x_[j];
                const double square = dot(offset, offset);
                if (square >= 4.0 * pool_ball * pool_ball) continue;
                const double distance = std::sqrt(square);
                const double depth = 2.0 * pool_ball - distance;
                const bool is_loading = dot(v_[i] - v_[j], offset) <= 0.0;
                const double force = stiffness * std::pow(depth, 1.5);
                const Vec2 push = offset * (force * (is_loading ? 1.0 : unloading_) / distance);
                force_[i] += push;
                force_[j] -= push;
            }
    }

    std::vector<Vec2> x_;
    std::vector<Vec2> v_;
    std::vector<Vec2> force_;
    double unloading_;
};

double speed_of(const World& world) {
    double square = 0.0;
    for (const Vec2 velocity : world.balls().velocity)
        square += dot(velocity, velocity);
    return std::sqrt(square);
}

}  // namespace

TEST_CASE("lasting impact: a break is that of a slow model of the springs, where racks are plain") {
    struct Row {
        double speed, gap, restitution;
    };
    for (const Row& row : {Row{2.0, 5e-5, 0.95}, Row{10.0, 5e-5, 0.95}, Row{13.0, 5e-5, 1.0},
                           Row{8.0, 1e-4, 0.9}, Row{10.0, 2e-5, 0.95}}) {
        CAPTURE(row.speed);
        CAPTURE(row.gap);
        World world = rack(row.speed, row.gap, row.restitution, 1);
        World plain = world;
        plain.edit_definition().model.modulus.reset();
        SlowModel slow(world, row.restitution);
        // The impact takes 2 ms at most. By then no second one has come.
        const double seconds = 0.015 + 0.075 / row.speed;
        slow.run(seconds);
        run(world, seconds, 1.0 / seconds);
        run(plain, seconds, 1.0 / seconds);
        double off = 0.0;
        double plain_off = 0.0;
        double furthest = 0.0;
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const Vec2 error = world.balls().velocity[i] - slow.velocities()[i];
            const Vec2 plain_error = plain.balls().velocity[i] - slow.velocities()[i];
            off += dot(error, error);
            plain_off += dot(plain_error, plain_error);
            furthest = std::max(furthest, length(world.balls().position[i] - slow.positions()[i]));
        }
        off = std::sqrt(off) / row.speed;
        plain_off = std::sqrt(plain_off) / row.speed;
        MESSAGE(row.speed << " m/s, gap " << row.gap << ": velocities off by " << off
                          << " of the cue ball's, without a modulus by " << plain_off
                          << "; places by " << furthest);
        // What remains is that normals turn and balls move during the impact, by up to 1 mm.
        CHECK(off < 0.025);
        CHECK(plain_off > 0.1);
        CHECK(furthest < 0.2 * pool_ball);
    }
}

TEST_CASE("lasting impact: the break of a perfect rack has the published speeds") {
    // J. Belk, "Perfectly centered break of a perfectly aligned pool ball rack", Mathematics Stack
    // Exchange (2014): Hertz's springs in Mathematica, in the limit of stiff balls.
    World world = rack(10.0, 0.0, 1.0, 1);
    world.edit_balls().position[0].y = 0.0;
    run(world, 0.015);
    const std::vector<double> speeds{1.79, 1.20, 1.57, 1.57, 1.42, 0.12, 1.42, 1.31,
                                     0.25, 0.25, 1.31, 5.60, 2.57, 2.63, 2.57, 5.60};
    REQUIRE(world.balls().size() == speeds.size());
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(length(world.balls().velocity[i]) - speeds[i]) < 0.01);
    }
}

TEST_CASE("lasting impact: every ball of a rack leaves, where impulses in turn leave some behind") {
    for (const double speed : {6.0, 8.0, 10.0, 13.0}) {
        CAPTURE(speed);
        World world = rack(speed, 5e-5, 0.95, 2);
        World plain = world;
        plain.edit_definition().model.modulus.reset();
        run(world, 0.1);
        run(plain, 0.1);
        const auto slow_ones = [&](const World& after) {
            return std::ranges::count_if(after.balls().velocity, [&](Vec2 velocity) {
                return length(velocity) < 0.025 * speed;
            });
        };
        CHECK(slow_ones(world) <= 3);
        CHECK(slow_ones(plain) >= 6);
    }
}

TEST_CASE("lasting impact: momentum and angular momentum are kept, energy is not gained") {
    for (std::uint64_t who = 0; who < 20; ++who) {
        CAPTURE(who);
        const double restitution = who % 2 == 0 ? 1.0 : draw(0.3, 1.0, who, 100);
        World world = rack(draw(1.0, 13.0, who, 101), draw(0.0, 2e-4, who, 102), restitution, who);
        const Totals before = totals(world);
        run(world, 0.2);
        const Totals after = totals(world);
        CHECK(length(after.momentum - before.momentum) < 1e-14 * length(before.momentum));
        const double lever = length(before.momentum) * 0.1;
        CHECK(std::abs(after.angular_momentum - before.angular_momentum) < 1e-12 * lever);
        const double gain = after.kinetic_energy / before.kinetic_energy - 1.0;
        CHECK(gain < 2e-14);
        if (restitution == 1.0) CHECK(gain > -2e-14);
    }
}

TEST_CASE("lasting impact: auto picks the solver that knows it") {
    const World world = rack(1.0, 0.0, 1.0, 1);
    const SolverPick pick = pick_solver(world);
    CHECK(pick.settings.kind == SolverKind::event);
    CHECK(pick.reason.find("contacts last") != std::string::npos);
}

TEST_CASE("lasting impact: two balls alone have the bits of an impact that takes no time") {
    World world = free_flight(0.9);
    put(world, {-0.2, 0.01}, {3.0, 0.1}, 0.9);
    put(world, {0.0, 0.0}, {}, 0.9);
    put(world, {0.0, 0.2}, {0.0, -1.0}, 0.9);  // comes later
    World plain = world;
    plain.edit_definition().model.modulus.reset();
    for (int i = 0; i < 10; ++i) {
        run(world, 0.05);
        run(plain, 0.05);
        REQUIRE(world.balls().position == plain.balls().position);
        REQUIRE(world.balls().velocity == plain.balls().velocity);
    }
    CHECK(world.ledger().ball_ball_collisions >= 2);
}

TEST_CASE("lasting impact: a gap counts if it closes in time, however it came about") {
    // Two balls in a row, hit at 2 m/s: a contact takes 0.34 ms, in which the first goes 0.3 mm.
    const auto last_speed = [](double gap) {
        World world = free_flight(1.0);
        put(world, {-0.1, 0.0}, {2.0, 0.0}, 1.0);
        put(world, {0.0, 0.0}, {}, 1.0);
        put(world, {2.0 * pool_ball + gap, 0.0}, {}, 1.0);
        run(world, 0.2);
        return world.balls().velocity[2].x;
    };
    CHECK(last_speed(0.0) == doctest::Approx(1.987).epsilon(2e-3));
    CHECK(last_speed(1e-3) == 2.0);
    double before = last_speed(0.0);
    for (const double gap : {2e-5, 5e-5, 1e-4, 2e-4}) {
        const double speed = last_speed(gap);
        CHECK(speed >= before - 1e-3);
        before = speed;
    }
}

TEST_CASE("lasting impact: a break on cloth ends at rest, without overlap or a gain of energy") {
    for (std::uint64_t who = 0; who < 9; ++who) {
        CAPTURE(who);
        const double gap = who % 3 == 0 ? 0.0 : draw(0.0, 1e-4, who, 0);
        World world = break_shot(gap, {draw(6.0, 13.0, who, 1), draw(-0.2, 0.2, who, 2)},
                                 {draw(-6.0, 10.0, who, 3), 0.0}, draw(-60.0, 60.0, who, 5),
                                 draw(-0.02, 0.02, who, 6));
        world.edit_definition().model.modulus = phenolic;
        Solver solver({.kind = SolverKind::event});
        double energy = totals(world).kinetic_energy;
        for (int i = 0; i < 60 * 240 && energy > 0.0; ++i) {
            REQUIRE(solver.tick(world) == TickOutcome::done);
            const double now = totals(world).kinetic_energy;
            REQUIRE(now <= energy * (1.0 + 1e-13));
            energy = now;
            if (i % 24 == 0) CHECK(deepest_overlap(world) < 2e-6 * pool_ball);
        }
        CHECK(energy == 0.0);
    }
}

TEST_CASE("lasting impact: a break has the same bits at any rate, and from any snapshot") {
    World slow = break_shot(5e-5, {10.0, 0.1}, {4.0, 0.0}, 30.0, 0.01);
    slow.edit_definition().model.modulus = phenolic;
    World fast = slow;
    for (int second = 0; second < 8; ++second) {
        run(slow, 1.0, 60.0);
        World copy = fast;  // and a solver that has seen nothing
        run(copy, 1.0, 1000.0);
        run(fast, 1.0, 1000.0);
        REQUIRE(slow.balls().position == fast.balls().position);
        REQUIRE(slow.balls().velocity == fast.balls().velocity);
        REQUIRE(slow.balls().roll == fast.balls().roll);
        REQUIRE(slow.balls().spin == fast.balls().spin);
        REQUIRE(copy.balls().position == fast.balls().position);
    }
    CHECK(slow.ledger().ball_ball_collisions > 30);
}

TEST_CASE("lasting impact: the order of the balls in the file shows in rounding alone") {
    const World start = rack(10.0, 5e-5, 0.95, 3);
    std::vector<std::size_t> order(start.balls().size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = (i * 7 + 3) % order.size();
    World other = free_flight(0.95);
    for (const std::size_t i : order)
        put(other, start.balls().position[i], start.balls().velocity[i], 0.95);
    World world = start;
    run(world, 0.02, 1000.0);
    run(other, 0.02, 1000.0);
    for (std::size_t i = 0; i < order.size(); ++i)
        CHECK(length(other.balls().velocity[i] - world.balls().velocity[order[i]]) < 1e-12);
    CHECK(speed_of(world) < 10.0);
}

TEST_CASE("lasting impact: its contacts are told in the order in which they first touched") {
    World world = rack(10.0, 5e-5, 0.95, 4);
    world.edit_definition().rate = 10.0;
    Solver solver({.kind = SolverKind::event});
    solver.tick(world);
    REQUIRE(solver.contacts().size() > 15);
    CHECK(solver.contacts()[0].a == number(world.balls().id[0]));
    CHECK(solver.contacts()[0].b == number(world.balls().id[1]));
    CHECK(solver.contacts()[0].approach == doctest::Approx(10.0).epsilon(0.02));
    for (const Contact& contact : solver.contacts())
        CHECK(contact.impulse > 0.0);
}

TEST_CASE("lasting impact: a row that is frozen to a cushion sends the ball back") {
    World world = free_flight(0.95);
    add_capsule(world, {{3.0 * pool_ball, -1.0}, {3.0 * pool_ball, 1.0}, 0.0}, 0);
    put(world, {-0.2, 0.0}, {2.0, 0.0}, 0.95);
    put(world, {0.0, 0.0}, {}, 0.95);
    put(world, {2.0 * pool_ball, 0.0}, {}, 0.95);
    const double before = totals(world).kinetic_energy;
    run(world, 1.0);
    CHECK(totals(world).kinetic_energy < before);
    CHECK(world.balls().velocity[0].x < 0.0);
    CHECK(world.balls().position[2].x <= 2.0 * pool_ball + 1e-12);
    CHECK(deepest_overlap(world) < 1e-9);
}

TEST_CASE("lasting impact: through a frozen pair the second ball is thrown, by friction alone") {
    // The first ball is hit at 30 degrees to the line of the two. Without friction the second one
    // leaves along that line; friction throws it the way the first one slips, by less than its
    // angle.
    const auto angle = [](double friction, double modulus) {
        World world = scenes::cloth_table(0.95, friction);
        if (modulus > 0.0) world.edit_definition().model.modulus = modulus;
        const Vec2 way{std::sqrt(0.75), 0.5};
        scenes::put(world, {0.0, 0.0});
        scenes::put(world, {2.0 * pool_ball, 0.0});
        scenes::put(world, way * (-0.2), way * 3.0);
        while (world.ledger().ball_ball_collisions == 0)
            run(world, 1.0 / 240.0);
        const Vec2 off = world.balls().velocity[1];
        CHECK(length(off) > 1.0);
        return std::atan2(off.y, off.x) * 180.0 / pi;
    };
    for (const double modulus : {0.0, phenolic}) {
        CAPTURE(modulus);
        CHECK(std::abs(angle(0.0, modulus)) < 1e-9);
        const double thrown = angle(0.05, modulus);
        MESSAGE("thrown by " << thrown << " degrees");
        CHECK(thrown > 1.0);
        CHECK(thrown < std::atan(0.05) * 180.0 / pi + 1e-9);
    }
}
