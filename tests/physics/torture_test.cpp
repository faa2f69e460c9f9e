#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include <doctest/doctest.h>

#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/totals.h"
#include "physics/world/random.h"
#include "support/sanitizers.h"

// Every solver at the extremes. `swept`, `contact` and `event` promise: all numbers finite, no ball
// lost, no energy gained beyond rounding. What the others do is printed as a table;
// docs/accuracy.md has it.

using namespace carom;
using carom::test::has_sanitizers;

namespace {

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 577'215, RandomStream::level, who, index);
}

double draw_size(double low, double high, std::uint64_t who, std::uint64_t index) {
    return std::pow(10.0, draw(low, high, who, index));
}

struct Ordeal {
    World world;
    Box inside;  ///< where every centre must stay
    int ticks = 240;
    /// Before each tick: what hands do. Where there are hands, they may give energy.
    std::function<void(World&)> drive = {};
};

struct Trial {
    const char* name;
    std::uint64_t variants;
    Ordeal (*make)(std::uint64_t who);
};

constexpr Box room{{-6.0, -6.0}, {6.0, 6.0}};

// Balls on a lattice that fills the room, off its middle lines, with random velocities.
void add_crowd(World& world, std::uint64_t who, int side, const auto& radius_of,
               const auto& mass_of) {
    const double pitch = 12.0 / side;
    for (int i = 0; i < side * side; ++i) {
        const auto n = static_cast<std::uint64_t>(i);
        const double radius = radius_of(n) * pitch * 0.45;
        const Vec2 at{-6.0 + pitch * (i % side + 0.5), -6.0 + pitch * (i / side + 0.5)};
        add_ball(world, {.position = at,
                         .velocity = {draw(-3, 3, who, 4 * n), draw(-3, 3, who, 4 * n + 1)},
                         .radius = radius,
                         .mass = mass_of(n, radius)});
    }
}

World room_world() {
    World world = scenes::empty();
    scenes::add_walls(world, room);
    return world;
}

Ordeal masses(std::uint64_t who) {
    World world = room_world();
    add_crowd(
        world, who, 4, [](std::uint64_t) { return 0.4; },
        [&](std::uint64_t n, double) { return draw_size(-6, 6, who, 4 * n + 2); });
    return {world, room};
}

Ordeal radii(std::uint64_t who) {
    World world = room_world();
    add_crowd(
        world, who, 6,
        [&](std::uint64_t n) { return n == 0 ? 1.0 : draw_size(-6, 0, who, 4 * n + 2); },
        [](std::uint64_t, double radius) { return radius * radius; });
    return {world, room};
}

Ordeal far_off(std::uint64_t who) {
    World world = scenes::empty();
    const Vec2 away{who % 2 == 0 ? 1e9 : -1e9, draw(-1e9, 1e9, who, 999)};
    const Vec2 off{std::floor(away.x), std::floor(away.y)};
    const Box box{room.low + off, room.high + off};
    scenes::add_walls(world, box);
    add_crowd(
        world, who, 5, [](std::uint64_t) { return 0.9; },
        [](std::uint64_t, double) { return 1.0; });
    for (Vec2& p : world.edit_balls().position)
        p += off;
    return {world, box};
}

Ordeal rates(std::uint64_t who) {
    World world = room_world();
    constexpr double all[] = {1e9, 1e6, 1e3, 10.0, 1.0};
    world.edit_definition().rate = all[who % 5];
    add_crowd(
        world, who, 5, [](std::uint64_t) { return 1.0; },
        [](std::uint64_t, double) { return 1.0; });
    if (who >= 5) {
        // A gravity under which a ball falls a part of the room in a second.
        world.edit_definition().model.gravity = Vec2{0.0, -2.0};
    }
    return {world, room};
}

// Along a wall, and past another ball, at an angle of 1e-8.
Ordeal grazes(std::uint64_t who) {
    World world = room_world();
    const double speed = draw_size(-1, 3, who, 0);
    const double angle = who % 2 == 0 ? 1e-8 : -1e-8;
    const Vec2 velocity{speed, -speed * angle};
    add_ball(world, {.position = {-5.0, -5.5 + 1e-9}, .velocity = velocity, .radius = 0.5});
    add_ball(world, {.position = {0.0, 2.0}, .velocity = {}, .radius = 0.5});
    add_ball(world, {.position = {-5.0, 3.0 - 5e-9}, .velocity = velocity, .radius = 0.5});
    const Vec2 peg{0.0, -2.0};
    add_capsule(world, {peg, peg, 0.0}, 0);
    add_ball(world, {.position = {-5.0, -1.5}, .velocity = velocity, .radius = 0.5});
    return {world, room, 600};
}

Ordeal degenerate_edges(std::uint64_t who) {
    World world = room_world();
    for (std::uint64_t i = 0; i < 8; ++i) {
        // On the lattice's corners: points, thin lines, lines along each other, a line that is
        // shorter than rounding, and one edge three times.
        const Vec2 at{-4.0 + 4.0 * static_cast<double>(i % 3),
                      -4.0 + 4.0 * static_cast<double>(i / 3)};
        const Vec2 way{draw(-0.9, 0.9, who, 900 + 2 * i), draw(-0.9, 0.9, who, 901 + 2 * i)};
        if (i % 4 == 0) add_capsule(world, {at, at, 0.0}, 0);
        if (i % 4 == 1) add_capsule(world, {at - way * 0.1, at + way * 0.1, 0.0}, 0);
        if (i % 4 == 2) add_capsule(world, {at, at + way * 1e-16, 0.01}, 0);
        if (i % 4 == 3)
            for (int k = 0; k < 3; ++k)
                add_capsule(world, {at, at + Vec2{0.1, 0.0}, 0.0}, 0);
    }
    add_crowd(
        world, who, 6, [](std::uint64_t) { return 0.7; },
        [](std::uint64_t, double) { return 1.0; });
    return {world, room, 600};
}

Ordeal coincident(std::uint64_t who) {
    World world = room_world();
    const std::size_t pile = 2 + who % 5;
    for (std::uint64_t i = 0; i < pile; ++i)
        add_ball(world, {.position = {1.0, 1.0},
                         .velocity = who % 3 == 0 ? Vec2{1.0, 0.0}
                                                  : Vec2{draw(-3, 3, who, 2 * i),
                                                         draw(-3, 3, who, 2 * i + 1)},
                         .radius = 0.5});
    // A centre on the spine of an edge, and one on a point.
    add_capsule(world, {{-4.0, -3.0}, {-2.0, -3.0}, who % 2 == 0 ? 0.0 : 0.3}, 0);
    add_ball(world, {.position = {-3.0, -3.0}, .velocity = {0.3, 1.0}, .radius = 0.5});
    add_capsule(world, {{3.0, -3.0}, {3.0, -3.0}, 0.0}, 0);
    add_ball(world, {.position = {3.0, -3.0}, .velocity = {}, .radius = 0.5});
    return {world, room, 600};
}

// Two edges close on balls that have nowhere to go.
Ordeal squeeze(std::uint64_t who) {
    World world = room_world();
    world.edit_definition().materials[0].restitution =
        world.edit_definition().kinds[0].restitution = who % 2 == 0 ? 1.0 : 0.7;
    const CapsuleId left = add_capsule(world, {{-5.0, -6.0}, {-5.0, 6.0}, 0.2}, 0);
    const CapsuleId right = add_capsule(world, {{5.0, -6.0}, {5.0, 6.0}, 0.2}, 0);
    for (std::uint64_t i = 0; i < 1 + who % 4; ++i)
        add_ball(world, {.position = {-3.0 + 2.0 * static_cast<double>(i), draw(-4, 4, who, i)},
                         .velocity = {0.0, draw(-1, 1, who, 10 + i)},
                         .radius = 0.5});
    const double speed = draw_size(-1, 1.5, who, 20);
    return {
        world, room, 600, [=](World& w) {
            const double x = std::max(0.0, 5.0 - speed * w.time());
            w.edit_held_capsules() = {{left, {-x, -6.0}, {-x, 6.0}}, {right, {x, -6.0}, {x, 6.0}}};
        }};
}

// A rack that touches, hit at its tip; and a ring that closes on its middle.
Ordeal at_once(std::uint64_t who) {
    World world = room_world();
    const double r = 0.25;
    if (who % 2 == 0) {
        const double high = std::sqrt(3.0) * r;
        for (int row = 0; row < 6; ++row)
            for (int i = 0; i <= row; ++i)
                add_ball(
                    world,
                    {.position = {high * row, r * (2 * i - row)}, .velocity = {}, .radius = r});
        add_ball(world, {.position = {-4.0, who % 4 == 0 ? 0.0 : draw(-0.2, 0.2, who, 0)},
                         .velocity = {draw_size(0, 4, who, 1), 0.0},
                         .radius = r});
    } else {
        add_ball(world, {.position = {}, .velocity = {}, .radius = r});
        const std::size_t count = 3 + who % 4;
        for (std::size_t i = 0; i < count; ++i) {
            const double angle =
                6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
            const Vec2 way{std::cos(angle), std::sin(angle)};
            add_ball(world, {.position = way * 3.0, .velocity = -way * 2.0, .radius = r});
        }
    }
    return {world, room};
}

Ordeal heap(std::uint64_t who) {
    World world = room_world();
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().materials[0].restitution =
        world.edit_definition().kinds[0].restitution = draw(0.0, 0.9, who, 999);
    add_crowd(
        world, who, 6, [&](std::uint64_t n) { return draw(0.3, 1.0, who, 4 * n + 2); },
        [&](std::uint64_t n, double) { return draw_size(-2, 2, who, 4 * n + 3); });
    return {world, room, 120};
}

// In a shaft, so that the heap is deep: light balls bear heavy ones, and all rub.
Ordeal rubbing_heap(std::uint64_t who) {
    World world = scenes::empty();
    const Box shaft{{-3.0, 0.0}, {3.0, 40.0}};
    scenes::add_walls(world, shaft);
    world.edit_definition().model.gravity = Vec2{0.0, -10.0};
    world.edit_definition().model.spin = who % 2 == 0 ? 0.5 : 0.4;
    world.edit_definition().model.inelastic = true;
    const double restitution = who % 4 < 2 ? 0.5 : 0.0;
    const double friction = who % 3 == 0 ? 1.0 : 0.4;
    world.edit_definition().materials[0] = {.restitution = restitution, .friction = friction};
    world.edit_definition().kinds[0] = {
        .radius = 0.5, .restitution = restitution, .friction = friction};
    for (int i = 0; i < 40; ++i) {
        const auto n = static_cast<std::uint64_t>(i);
        const double x = -2.4 + 1.15 * (i % 5) + draw(-0.05, 0.05, who, 2 * n);
        const double power = who < 4 ? 2.6 : 4.0;
        add_ball(world, {.position = {x, 0.6 + 1.1 * (i / 5)},
                         .velocity = {},
                         .radius = 0.5,
                         .mass = draw_size(-power, power, who, 2 * n + 1)});
    }
    return {world, shaft, 600};
}

constexpr Trial trials[] = {{"masses 1e12 apart", 5, masses},
                            {"radii 1e6 apart", 5, radii},
                            {"1e9 from the origin", 4, far_off},
                            {"ticks of 1e-9 to 1 s", 10, rates},
                            {"grazing at 1e-8 rad", 10, grazes},
                            {"edges without length or radius", 5, degenerate_edges},
                            {"coinciding centres", 10, coincident},
                            {"squeezed by closing edges", 16, squeeze},
                            {"many contacts at once", 12, at_once},
                            {"heaps of unequal masses", 4, heap},
                            {"deep heaps of unequal masses, with friction", 6, rubbing_heap}};

struct Outcome {
    std::size_t not_finite = 0;
    std::size_t lost = 0;
    double gain = 0.0;     ///< most energy gained, of the most kinetic energy
    double fastest = 0.0;  ///< speed where there are hands
};

void run_ordeal(Ordeal ordeal, SolverKind kind, Outcome& outcome) {
    World& world = ordeal.world;
    Solver solver({.kind = kind});
    const Totals start = totals(world);
    const double before = start.kinetic_energy + start.potential_energy;
    double scale = start.kinetic_energy;
    const std::size_t count = world.balls().size();
    for (int tick = 0; tick < ordeal.ticks; ++tick) {
        if (ordeal.drive) ordeal.drive(world);
        solver.tick(world);  // time may stand still
        const Totals now = totals(world);
        scale =
            std::max(scale, now.kinetic_energy -
                                std::max(0.0, now.kinetic_energy + now.potential_energy - before));
        const double gained = now.kinetic_energy + now.potential_energy - before;
        if (!ordeal.drive && scale > 0.0) outcome.gain = std::max(outcome.gain, gained / scale);
        if (ordeal.drive)
            for (const Vec2 v : world.balls().velocity)
                outcome.fastest = std::max(outcome.fastest, length(v));
    }
    outcome.lost += count - world.balls().size();
    const Box near = grow(ordeal.inside, 1e-6);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 p = world.balls().position[i];
        const Vec2 v = world.balls().velocity[i];
        const bool is_finite =
            std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(v.x) && std::isfinite(v.y);
        outcome.not_finite += !is_finite;
        outcome.lost += !contains(near, p);
    }
}

bool promises(SolverKind kind) {
    return kind == SolverKind::swept || kind == SolverKind::contact || kind == SolverKind::event;
}

std::string text(double value) {
    char line[32];
    std::snprintf(line, sizeof line, "%.1e", value);
    return value == 0.0 ? "0" : line;
}

// A ball of radius 1 in a closed box, 60 ticks a second; whether it gets out in three ticks.
bool escapes(Solver& solver, std::uint64_t shot) {
    World world = scenes::empty();
    world.edit_definition().rate = 60.0;
    const double wall = shot % 4 == 0 ? 0.0 : draw(0.0, 1e-3, shot, 5);
    const Vec2 corners[] = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
    for (int i = 0; i < 4; ++i)
        add_capsule(world, {corners[i], corners[(i + 1) % 4], wall}, 0);
    const double angle = draw(0.0, 6.283185307179586, shot, 0);
    add_ball(world, {.position = {draw(-40, 40, shot, 1), draw(-40, 40, shot, 2)},
                     .velocity = Vec2{std::cos(angle), std::sin(angle)} *
                                 (shot % 8 == 0 ? 1e6 : draw_size(0, 6, shot, 3))});
    for (int i = 0; i < 3; ++i)
        solver.tick(world);
    const Vec2 p = world.balls().position[0];
    return !(std::fabs(p.x) <= 49.0 + 1e-6 && std::fabs(p.y) <= 49.0 + 1e-6);
}

// Runs one in so many of each trial's variants, at least one, under every solver.
void torture(std::uint64_t one_in) {
    std::string head = "| extreme |";
    std::string line = "|---|";
    for (const SolverKind kind : solvers_available()) {
        head += " " + std::string(name(kind)) + " |";
        line += "---|";
    }
    std::string table = head + "\n" + line + "\n";
    for (const Trial& trial : trials) {
        CAPTURE(trial.name);
        table += "| " + std::string(trial.name) + " |";
        for (const SolverKind kind : solvers_available()) {
            CAPTURE(name(kind));
            Outcome outcome;
            std::size_t balls = 0;
            bool has_hands = false;
            for (std::uint64_t who = 0; who < trial.variants; who += one_in) {
                const Ordeal ordeal = trial.make(who);
                balls += ordeal.world.balls().size();
                has_hands |= static_cast<bool>(ordeal.drive);
                run_ordeal(ordeal, kind, outcome);
            }
            table += outcome.lost == 0 ? " none lost"
                                       : " " + std::to_string(outcome.lost) + " of " +
                                             std::to_string(balls) + " lost";
            if (outcome.not_finite > 0)
                table += ", " + std::to_string(outcome.not_finite) + " not finite";
            table += has_hands ? ", fastest " + text(outcome.fastest)
                               : ", energy +" + text(outcome.gain);
            table += " |";
            if (!promises(kind)) continue;
            CHECK(outcome.not_finite == 0);
            CHECK(outcome.lost == 0);
            CHECK(outcome.gain < 1e-10);
        }
        table += "\n";
    }
    MESSAGE("\n", table);
}

}  // namespace

TEST_CASE("torture: finite, nothing lost, no energy gained, by the solvers that promise it") {
    torture(has_sanitizers ? 20 : 5);
}

TEST_SUITE("long") {
    TEST_CASE("torture: every variant") {
        torture(1);
    }
}

// A ball that waits behind another does not feel what pushes the others off it: started from again,
// that impulse would push them again in each substep.
TEST_CASE("torture: contact: deep heaps with masses 1e8 apart gain no energy where balls wait") {
    for (const std::uint64_t who : {21, 33, 36}) {
        if (has_sanitizers && who != 21) continue;
        CAPTURE(who);
        Outcome outcome;
        run_ordeal(rubbing_heap(who), SolverKind::contact, outcome);
        CHECK(outcome.not_finite == 0);
        CHECK(outcome.lost == 0);
        CHECK(outcome.gain < 1e-10);
    }
}

TEST_CASE("torture: of 10,000 shots at thin walls none gets through") {
    const std::uint64_t shots = has_sanitizers ? 1000 : 10'000;
    for (const SolverKind kind : solvers_available()) {
        CAPTURE(name(kind));
        Solver solver({.kind = kind});
        int out = 0;
        for (std::uint64_t shot = 0; shot < shots; ++shot)
            out += escapes(solver, shot);
        MESSAGE(name(kind), ": ", out, " of ", shots, " shots get through");
        if (promises(kind)) CHECK(out == 0);
    }
}

TEST_CASE("a ball squeezed between hands does not cost thousands of impacts a tick") {
    World world = room_world();
    const CapsuleId left = add_capsule(world, {{-5.0, -6.0}, {-5.0, 6.0}, 0.2}, 0);
    const CapsuleId right = add_capsule(world, {{5.0, -6.0}, {5.0, 6.0}, 0.2}, 0);
    add_ball(world, {.position = {-3.0, 1.0}, .velocity = {0.0, 0.5}, .radius = 0.5});
    Solver solver({.kind = SolverKind::event});
    std::size_t most = 0;
    for (int tick = 0; tick < 400; ++tick) {
        const double x = std::max(0.0, 5.0 - 3.0 * world.time());
        world.edit_held_capsules() = {{left, {-x, -6.0}, {-x, 6.0}}, {right, {x, -6.0}, {x, 6.0}}};
        solver.tick(world);
        most = std::max(most, solver.contacts().size());
    }
    CHECK(most < 1000);
    CHECK(std::fabs(world.balls().position[0].x) < 1e-6);
    // The hands have stopped where they touch it.
    CHECK(world.capsules().shape[4].start.x == doctest::Approx(-0.7).epsilon(1e-9));
    CHECK(world.capsules().shape[5].start.x == doctest::Approx(0.7).epsilon(1e-9));
}
