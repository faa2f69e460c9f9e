#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "geometry/elementary.h"
#include "physics/laws/cloth.h"
#include "physics/solver.h"
#include "physics/support/cloth_table.h"
#include "physics/tick/totals.h"
#include "physics/world/fingerprint.h"
#include "physics/world/random.h"

// The solver `event` on cloth is exact, so tolerances against closed forms are those of rounding.

using namespace carom;

namespace {

using scenes::break_shot;
using scenes::cloth_table;
using scenes::put;
using scenes::put_cushions;
using scenes::solid;

constexpr double size_of_ball = scenes::pool_ball;

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 271'828, RandomStream::level, who, index);
}
Vec2 draw_vector(double most, std::uint64_t who, std::uint64_t index) {
    return {draw(-most, most, who, index), draw(-most, most, who, index + 1)};
}

std::size_t run(World& world, double seconds,
                SolverSettings settings = {.kind = SolverKind::event}) {
    Solver solver(settings);
    std::size_t contacts = 0;
    const auto ticks = static_cast<int>(seconds * world.rate() + 0.5);
    for (int i = 0; i < ticks; ++i) {
        CHECK(solver.tick(world) == TickOutcome::done);
        contacts += solver.contacts().size();
    }
    return contacts;
}

// Advances by one tick of that length.
void run_at_once(World& world, double seconds) {
    world.edit_definition().rate = 1.0 / seconds;
    Solver({.kind = SolverKind::event}).tick(world);
}

double degrees_between(Vec2 a, Vec2 b) {
    return std::atan2(cross(a, b), dot(a, b)) * 180.0 / pi;
}

// The object ball at the origin; the cue ball moves right and meets it at this cut.
Vec2 before_cut(double degrees, double way) {
    const auto [sine, cosine] = sin_cos(degrees * pi / 180.0);
    const double reach = 2.0 * size_of_ball;
    return {-reach * cosine - way, reach * sine};
}

bool all_are_still(const World& world) {
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (!(world.balls().velocity[i] == Vec2{}) || !(world.balls().roll[i] == Vec2{}))
            return false;
    return true;
}

}  // namespace

TEST_CASE(
    "event on cloth: sliding and rolling end when and where the closed forms say, in one tick") {
    for (std::uint64_t who = 0; who < 100; ++who) {
        CAPTURE(who);
        const Cloth cloth{.slide = draw(0.05, 0.5, who, 0),
                          .roll = draw(0.005, 0.02, who, 1),
                          .spin = draw(0.0, 15.0, who, 2),
                          .gravity = draw(1.0, 20.0, who, 3)};
        const Vec2 velocity = draw_vector(5.0, who, 4);
        const double speed = length(velocity);
        const Vec2 way = velocity / speed;
        const double force = cloth.slide * cloth.gravity;
        const double slides = 2.0 * speed / (7.0 * force);
        const double slid = 12.0 * speed * speed / (49.0 * force);
        World world = cloth_table(0.95, 0.05, cloth);
        put(world, {}, velocity, {}, 40.0);
        World later = world;
        World last = world;

        // Just before the end it still slides.
        run_at_once(world, slides * 0.999);
        CHECK(length(world.balls().velocity[0]) > speed * 5.0 / 7.0);
        CHECK(length(world.balls().velocity[0] - world.balls().roll[0]) > 0.0);
        CHECK(world.balls().spin[0] ==
              doctest::Approx(std::max(0.0, 40.0 - cloth.spin * slides * 0.999)).epsilon(1e-13));

        // Just after it, it rolls.
        const double more = 0.01 * slides;
        run_at_once(later, slides + more);
        const double brake = cloth.roll * cloth.gravity;
        const double rolling = speed * 5.0 / 7.0;
        const double place = slid + rolling * more - brake * more * more / 2.0;
        CHECK(length(later.balls().position[0] - way * place) < 1e-13 * place);
        CHECK(length(later.balls().velocity[0] - way * (rolling - brake * more)) < 1e-13 * speed);
        CHECK(later.balls().roll[0] == later.balls().velocity[0]);

        // Then it rests for good.
        const double rolls = rolling * rolling / (2.0 * brake);
        run_at_once(last, slides + rolling / brake + 1e-6);
        CHECK(length(last.balls().position[0] - way * (slid + rolls)) < 1e-13 * (slid + rolls));
        CHECK(all_are_still(last));
    }
}

TEST_CASE("event on cloth: a ball with any roll follows the closed forms, at any time") {
    for (std::uint64_t who = 0; who < 200; ++who) {
        CAPTURE(who);
        const Cloth cloth{.slide = draw(0.1, 0.4, who, 0), .roll = draw(0.005, 0.02, who, 1)};
        const Vec2 velocity = draw_vector(3.0, who, 2);
        const Vec2 roll = draw_vector(6.0, who, 4);
        const double spin = draw(-50.0, 50.0, who, 6);
        World world = cloth_table(1.0, 0.0, cloth);
        put(world, {}, velocity, roll, spin);
        const ClothState<double> start{{}, Vector<double>(velocity), Vector<double>(roll), spin};
        Solver solver({.kind = SolverKind::event});
        for (int i = 0; i < 1200; ++i) {
            solver.tick(world);
            if (i % 60 != 0) continue;
            const auto there = cloth_state_after(cloth, solid, start, world.time());
            CHECK(length(world.balls().position[0] - Vec2(there.position)) < 1e-12);
            CHECK(length(world.balls().velocity[0] - Vec2(there.velocity)) < 1e-12);
            CHECK(length(world.balls().roll[0] - Vec2(there.roll)) < 1e-12);
            CHECK(std::abs(world.balls().spin[0] - there.spin) < 1e-12);
        }
    }
}

TEST_CASE("event on cloth: two balls meet when their closed forms first touch, or not at all") {
    int met = 0;
    for (std::uint64_t who = 0; who < 300; ++who) {
        CAPTURE(who);
        World world = cloth_table(0.95, 0.05);
        std::array<ClothState<double>, 2> start;
        for (std::uint64_t i = 0; i < 2; ++i) {
            const Vec2 at = i == 0 ? draw_vector(0.1, who, 0) : Vec2{draw(0.2, 0.6, who, 2), 0.0};
            const Vec2 velocity{(i == 0 ? 1.0 : -0.5) * draw(0.0, 2.0, who, 3 + 10 * i),
                                draw(-0.4, 0.4, who, 4 + 10 * i)};
            const Vec2 roll = draw_vector(3.0, who, 5 + 10 * i);
            put(world, at, velocity, roll);
            start[i] = {Vector<double>(at), Vector<double>(velocity), Vector<double>(roll), 0.0};
        }
        const auto gap = [&](double time) {
            const Cloth& cloth = *world.model().cloth;
            const auto a = cloth_state_after(cloth, solid, start[0], time);
            const auto b = cloth_state_after(cloth, solid, start[1], time);
            return length(a.position - b.position) - 2.0 * size_of_ball;
        };
        // Bracketed by small steps, refined by bisection. Grazes shorter than a step are skipped.
        const double most = 4.0;
        const double step = 1e-3;
        std::optional<double> when;
        double least = 1.0;
        for (int i = 0; i * step < most && !when; ++i) {
            least = std::min(least, gap(i * step));
            if (gap((i + 1) * step) > 0.0) continue;
            double low = i * step;
            double high = low + step;
            for (int half = 0; half < 60; ++half) {
                const double middle = (low + high) / 2.0;
                (gap(middle) > 0.0 ? low : high) = middle;
            }
            when = high;
        }
        if (!when && least < 1e-5) continue;
        met += when.has_value();
        Solver solver({.kind = SolverKind::event});
        while (world.time() < most && solver.contacts().empty())
            solver.tick(world);
        REQUIRE(solver.contacts().empty() == !when);
        if (when) CHECK(std::abs(solver.contacts()[0].time - *when) < 1e-11);
    }
    CHECK(met > 80);
}

TEST_CASE("event on cloth: stun line, stop shot and the 30-degree rule are exact") {
    for (std::uint64_t who = 0; who < 100; ++who) {
        CAPTURE(who);
        const double speed = draw(0.5, 8.0, who, 0);
        const double cut = draw(5.0, 75.0, who, 1);
        World stun = cloth_table(1.0, 0.0);
        put(stun, {});
        put(stun, before_cut(cut, 1e-4), {speed, 0.0});
        Solver solver({.kind = SolverKind::event});
        stun.edit_definition().rate = 1e4;
        while (solver.contacts().empty())
            solver.tick(stun);
        CHECK(std::abs(degrees_between(stun.balls().velocity[0], stun.balls().velocity[1])) ==
              doctest::Approx(90.0).epsilon(2e-3));
        // The parabola in the rest of the tick bends that; the impulse itself is exact.
        CHECK(degrees_between({1.0, 0.0}, solver.contacts()[0].normal) ==
              doctest::Approx(-cut).epsilon(1e-10));

        World rolling = cloth_table(1.0, 0.0);
        put(rolling, {});
        put(rolling, before_cut(cut, 0.01), {speed, 0.0}, {speed, 0.0});
        run_at_once(rolling, 0.01 / speed + 2.0 * speed / (7.0 * 0.2 * 9.81) + 0.001);
        REQUIRE(rolling.balls().velocity[1] == rolling.balls().roll[1]);
        const auto [sine, cosine] = sin_cos(cut * pi / 180.0);
        const double turned = std::atan2(sine * cosine, sine * sine + 0.4) * 180.0 / pi;
        CHECK(degrees_between({1.0, 0.0}, rolling.balls().velocity[1]) ==
              doctest::Approx(turned).epsilon(1e-9));
        if (who == 0) {
            const double half = std::atan2(std::sqrt(3.0) / 4.0, 0.65) * 180.0 / pi;
            CHECK(half == doctest::Approx(33.67).epsilon(1e-4));
        }

        World stop = cloth_table(1.0, 0.0);
        put(stop, {});
        // The ball slides without spin at the impact.
        put(stop, {-2.0 * size_of_ball - 1e-6, 0.0}, {speed, 0.0});
        run_at_once(stop, 0.5);
        CHECK(std::abs(stop.balls().position[1].x + 2.0 * size_of_ball) < 1e-6);
        CHECK(length(stop.balls().velocity[1]) < 2e-5);
    }
}

TEST_CASE("event on cloth: throw follows Coulomb's law, within the published range") {
    for (const double mu : {0.03, 0.05, 0.08}) {
        for (std::uint64_t who = 0; who < 50; ++who) {
            CAPTURE(who);
            const double speed = draw(0.3, 5.0, who, 0);
            const double cut = draw(2.0, 60.0, who, 1);
            World world = cloth_table(0.95, mu);
            world.edit_definition().rate = 1e6;
            put(world, {});
            put(world, before_cut(cut, 1e-7), {speed, 0.0});
            Solver solver({.kind = SolverKind::event});
            while (world.balls().velocity[0] == Vec2{})
                solver.tick(world);
            const double thrown = cut + degrees_between({1.0, 0.0}, world.balls().velocity[0]);
            // The balls slip throughout, or stick: the slip is stopped by 1/7 of the tangential
            // speed.
            const auto [sine, cosine] = sin_cos(cut * pi / 180.0);
            const double sticking = sine / 7.0 / (0.975 * cosine);
            const double expected = std::atan(std::min(mu, sticking)) * 180.0 / pi;
            CHECK(thrown == doctest::Approx(expected).epsilon(1e-4));
            CHECK(thrown < 6.0);
        }
    }
}

TEST_CASE("event on cloth: 36 hard breaks lose no ball, gain no energy, and come to rest") {
    std::size_t contacts = 0;
    double deepest = 0.0;
    for (std::uint64_t who = 0; who < 36; ++who) {
        CAPTURE(who);
        // Every third rack is tight: its balls touch.
        const double gap = who % 3 == 0 ? 0.0 : draw(0.0, 1e-4, who, 0);
        const double speed = draw(9.0, 13.0, who, 1);
        World world = break_shot(gap, {speed, draw(-0.2, 0.2, who, 2)},
                                 {draw(-6.0, 10.0, who, 3), draw(-1.0, 1.0, who, 4)},
                                 draw(-60.0, 60.0, who, 5), draw(-0.02, 0.02, who, 6));
        Solver solver({.kind = SolverKind::event});
        double energy = totals(world).kinetic_energy;
        const int most = 60 * 240;
        for (int i = 0; i < most && !all_are_still(world); ++i) {
            REQUIRE(solver.tick(world) == TickOutcome::done);
            contacts += solver.contacts().size();
            const double now = totals(world).kinetic_energy;
            REQUIRE(now <= energy * (1.0 + 1e-13));
            energy = now;
            if (i % 24 == 0) deepest = std::max(deepest, deepest_overlap(world));
        }
        CHECK(all_are_still(world));
        REQUIRE(world.balls().size() == 16);
        for (const Vec2 position : world.balls().position) {
            CHECK(std::abs(position.x) <= 1.27 - size_of_ball + 1e-9);
            CHECK(std::abs(position.y) <= 0.635 - size_of_ball + 1e-9);
        }
    }
    MESSAGE("36 breaks: " << contacts << " contacts, deepest overlap " << deepest);
    CHECK(deepest < 2e-6 * size_of_ball);
}

TEST_CASE("event on cloth: a break has the same bits at 60 and at 1,000 ticks a second") {
    const World start = break_shot(5e-5, {10.0, 0.1}, {4.0, 0.0}, 30.0, 0.01);
    World slow = start;
    World fast = start;
    slow.edit_definition().rate = 60.0;
    fast.edit_definition().rate = 1000.0;
    for (int second = 0; second < 12; ++second) {
        run(slow, 1.0);
        run(fast, 1.0);
        REQUIRE(slow.balls().position == fast.balls().position);
        REQUIRE(slow.balls().velocity == fast.balls().velocity);
        REQUIRE(slow.balls().roll == fast.balls().roll);
        REQUIRE(slow.balls().spin == fast.balls().spin);
    }
    CHECK(slow.ledger().ball_ball_collisions > 50);
    CHECK(slow.ledger().ball_ball_collisions == fast.ledger().ball_ball_collisions);
}

TEST_CASE("event on cloth: a snapshot continues with the same bits, wherever it is taken") {
    World world = break_shot(5e-5, {10.0, 0.1}, {4.0, 0.0}, 30.0, 0.01);
    Solver solver({.kind = SolverKind::event});
    World copy = world;
    for (int tick = 0; tick < 2400; ++tick) {
        if (tick % 97 == 0) copy = world;
        solver.tick(world);
        if (tick % 97 > 20) continue;
        Solver other({.kind = SolverKind::event});
        other.tick(copy);
        REQUIRE(fingerprint(copy) == fingerprint(world));
    }
}

TEST_CASE("event on cloth: a break does not depend on the order of the file") {
    World world = break_shot(5e-5, {10.0, 0.1}, {4.0, 0.0}, 30.0, 0.01);
    World turned = cloth_table(0.95, 0.05);
    put_cushions(turned);
    const Balls& balls = world.balls();
    for (std::size_t i = balls.size(); i-- > 0;)
        put(turned, balls.position[i], balls.velocity[i], balls.roll[i], balls.spin[i]);
    run(world, 5.0);
    run(turned, 5.0);
    const std::size_t last = world.balls().size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        CHECK(world.balls().position[i] == turned.balls().position[last - i]);
        CHECK(world.balls().roll[i] == turned.balls().roll[last - i]);
    }
}

TEST_CASE("event on cloth: swept converges to its result for short ticks") {
    // Three balls and three cushions, which amplify errors little.
    const auto scene = [](double rate) {
        World world = cloth_table(0.95, 0.05);
        put_cushions(world);
        world.edit_definition().rate = rate;
        put(world, {-0.5, 0.0}, {2.0, 0.25}, {0.5, 0.0}, 20.0);
        put(world, {0.2, 0.1});
        put(world, {0.8, -0.2});
        return world;
    };
    World exact = scene(240.0);
    run(exact, 4.0);
    CHECK(exact.ledger().ball_ball_collisions > 0);
    CHECK(exact.ledger().ball_edge_collisions > 2);
    double before = 1.0;
    for (const double rate : {240.0, 1920.0, 15360.0}) {
        World swept = scene(rate);
        run(swept, 4.0, {.kind = SolverKind::swept});
        double worst = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            worst = std::max(worst, length(swept.balls().position[i] - exact.balls().position[i]));
        MESSAGE("swept at " << rate << " ticks a second is off by " << worst << " m");
        CHECK(worst < before / 4.0);
        before = worst;
    }
    CHECK(before < 1e-4);
}

TEST_CASE("event on cloth: more digits give the same result") {
    World world = cloth_table(0.95, 0.05);
    put_cushions(world);
    put(world, {-0.5, 0.0}, {2.0, 0.25}, {0.5, 0.0}, 20.0);
    put(world, {0.2, 0.1});
    put(world, {0.8, -0.2});
    World precise = world;
    run(world, 12.0);
    run(precise, 12.0, {.kind = SolverKind::event, .extended = true});
    CHECK(all_are_still(precise));
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(length(world.balls().position[i] - precise.balls().position[i]) < 1e-11);
}

TEST_CASE("event on cloth: touching balls at rest stay at rest") {
    World world = cloth_table(0.95, 0.05);
    put_cushions(world);
    put(world, {0.0, 0.635 - size_of_ball});                  // frozen to a cushion
    put(world, {2.0 * size_of_ball, 0.635 - size_of_ball});   // touches ball and cushion
    put(world, {1.27 - size_of_ball, 0.635 - size_of_ball});  // in a corner
    put(world, {-0.5, 0.0}, {}, {}, 80.0);                    // spins in place
    const World before = world;
    CHECK(run(world, 10.0) == 0);
    CHECK(world.balls().position == before.balls().position);
    CHECK(world.balls().spin[3] == 0.0);
    CHECK(all_are_still(world));
}

TEST_CASE(
    "event on cloth: a ball that turns towards a neighbour pushes it in finitely many impacts") {
    const double rail = 0.635 - size_of_ball;
    const double reach = 2.0 * size_of_ball;
    struct Case {
        const char* what;
        std::vector<Vec2> places;  // the first turns upwards, or rests against the last
        Vec2 velocity;
        Vec2 roll;
        std::size_t most;
    };
    const std::vector<Case> cases{
        {"a ball on a cushion", {{0.0, rail}}, {}, {0.0, 3.0}, 4},
        {"a ball along a cushion", {{0.0, rail}}, {1.0, 0.0}, {2.0, 3.0}, 8},
        {"a ball in a corner", {{1.27 - size_of_ball, rail}}, {}, {3.0, 3.0}, 8},
        {"a ball near a cushion", {{0.0, rail - 1e-4}}, {}, {0.0, 3.0}, 200},
        {"a ball on another", {{0.0, 0.0}, {0.0, reach}}, {}, {0.0, 3.0}, 20'000},
        {"a ball on one on a cushion", {{0.0, rail - reach}, {0.0, rail}}, {}, {0.0, 3.0}, 40'000},
        {"a ball on two on a cushion",
         {{0.0, rail - reach * std::sqrt(0.75)}, {-size_of_ball, rail}, {size_of_ball, rail}},
         {},
         {0.0, 3.0},
         40'000},
    };
    for (const Case& each : cases) {
        const std::string what = each.what;
        CAPTURE(what);
        World world = cloth_table(0.95, 0.05);
        put_cushions(world);
        for (std::size_t i = 0; i < each.places.size(); ++i)
            put(world, each.places[i], i == 0 ? each.velocity : Vec2{},
                i == 0 ? each.roll : Vec2{});
        Solver solver({.kind = SolverKind::event});
        double energy = totals(world).kinetic_energy;
        std::size_t contacts = 0;
        double deepest = 0.0;
        for (int i = 0; i < 30 * 240; ++i) {
            REQUIRE(solver.tick(world) == TickOutcome::done);
            contacts += solver.contacts().size();
            const double now = totals(world).kinetic_energy;
            REQUIRE(now <= energy * (1.0 + 1e-13));
            energy = now;
            deepest = std::max(deepest, deepest_overlap(world));
        }
        MESSAGE(what << ": " << contacts << " contacts, deepest overlap " << deepest);
        CHECK(contacts <= each.most);
        CHECK(all_are_still(world));
        CHECK(deepest < 2e-6 * size_of_ball);
        for (const Vec2 position : world.balls().position)
            CHECK(position.y <= rail + 1e-8 * size_of_ball);
    }
}

TEST_CASE("event on cloth: a kinematic ball or edge pushes resting balls") {
    for (const bool is_ball : {true, false}) {
        CAPTURE(is_ball);
        World world = cloth_table(0.95, 0.05);
        put(world, {0.2, 0.0});
        put(world, {-0.2, 0.0});
        const CapsuleId edge = add_capsule(world, {{0.0, -0.3}, {0.0, 0.3}, 0.0}, 0);
        if (is_ball) remove_capsule(world, edge);
        Solver solver({.kind = SolverKind::event});
        for (int i = 0; i < 10; ++i)
            solver.tick(world);
        for (int i = 1; i <= 120; ++i) {
            const double x = i / 240.0;
            if (is_ball)
                world.edit_held_balls() = {{BallId{1}, {-0.2 + x, 0.0}}};
            else
                world.edit_held_capsules() = {{edge, {x, -0.3}, {x, 0.3}}};
            solver.tick(world);
        }
        const double hand = is_ball ? world.balls().position[1].x + 2.0 * size_of_ball
                                    : world.capsules().shape[0].start.x + size_of_ball;
        CHECK(hand > 0.25);

        CHECK(world.balls().position[0].x > hand - 1e-3 * size_of_ball);
        world.edit_held_balls().clear();
        world.edit_held_capsules().clear();
        run(world, 30.0);
        CHECK(all_are_still(world));
    }
}

TEST_CASE("event on cloth: a ball struck from outside restarts, the others continue") {
    World world = break_shot(5e-5, {10.0, 0.1}, {4.0, 0.0}, 30.0, 0.01);
    run(world, 20.0);
    World copy = world;
    Solver solver({.kind = SolverKind::event});
    solver.tick(world);
    Solver other({.kind = SolverKind::event});
    other.tick(copy);
    for (World* each : {&world, &copy}) {
        each->edit_balls().roll[3] = {1.5, 0.5};
        each->edit_balls().spin[4] = 12.0;
    }
    for (int i = 0; i < 480; ++i) {
        solver.tick(world);
        // A fresh solver.
        Solver({.kind = SolverKind::event}).tick(copy);
        REQUIRE(fingerprint(copy) == fingerprint(world));
    }
    CHECK(length(world.balls().roll[3]) > 0.0);
    CHECK(length(world.balls().roll[3]) < 1.6);
}

TEST_CASE("event on cloth: auto picks it") {
    CHECK(pick_solver(cloth_table(0.95, 0.05)).settings.kind == SolverKind::event);
}
