#include "physics/world/world.h"

#include <set>

#include <doctest/doctest.h>

#include "physics/broad_phase/cell_frame.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/emitters_and_sinks.h"
#include "physics/tick/totals.h"
#include "physics/world/fingerprint.h"
#include "physics/world/random.h"

using namespace carom;

TEST_CASE("ids are unique, ascending, and survive removals") {
    World world = scenes::empty();
    const BallId a = add_ball(world, {.position = {0, 0}, .velocity = {}});
    const BallId b = add_ball(world, {.position = {5, 0}, .velocity = {}});
    remove_ball(world, a);
    const BallId c = add_ball(world, {.position = {9, 0}, .velocity = {}});
    CHECK(number(c) == 2);
    CHECK(index_of(world, b) == 0);
    CHECK(index_of(world, c) == 1);
    CHECK_FALSE(index_of(world, a));
    CHECK(world.ledger().removed.size() == 1);
    remove_ball(world, a);
    CHECK(world.ledger().removed.size() == 1);
}

TEST_CASE("unused features cost no bytes") {
    World world = scenes::empty();
    add_ball(world, {.position = {0, 0}, .velocity = {}});
    add_capsule(world, {{0, 0}, {1, 0}, 0}, 0);
    CHECK(world.balls().restitution.empty());
    CHECK(world.capsules().side.empty());
    add_ball(world, {.position = {9, 0}, .velocity = {}, .restitution = 0.5});
    CHECK(world.model().inelastic);
    CHECK(world.balls().restitution == std::vector<double>{1.0, 0.5});
    add_capsule(world, {{0, 5}, {1, 5}, 0}, 0, Side::left);
    CHECK(world.model().one_way);
    CHECK(world.capsules().side == std::vector<Side>{Side::both, Side::left});
    CHECK(world.balls().spin.empty());
}

TEST_CASE("spin stays with its ball, and counts in the sums and in the fingerprint") {
    World world = scenes::empty();
    world.edit_definition().model.spin = 0.4;
    for (const double spin : {1.0, 2.0, 3.0, 4.0})
        add_ball(
            world,
            {.position = {9 * spin, 0}, .velocity = {}, .radius = 2.0, .mass = 3.0, .spin = spin});
    const double inertia = 0.4 * 3.0 * 2.0 * 2.0;
    CHECK(totals(world).kinetic_energy == doctest::Approx(0.5 * inertia * (1 + 4 + 9 + 16)));
    CHECK(totals(world).angular_momentum == doctest::Approx(inertia * (1 + 2 + 3 + 4)));
    remove_ball(world, BallId{1});
    CHECK(world.balls().spin == std::vector<double>{1.0, 3.0, 4.0});
    World other = world;
    other.edit_balls().spin[0] = 1.5;
    CHECK(fingerprint(other) != fingerprint(world));
    world.edit_ledger().counters.push_back(0);
    world.edit_definition().zones.push_back(
        {.shape = {{27, 0}, {27, 0}, 1}, .effect = Zone::Effect::sink});
    SinkDrain().drain(world);
    CHECK(world.balls().spin == std::vector<double>{1.0, 4.0});
}

TEST_CASE("a ball that is elastic by its own key stays so when the scene becomes inelastic") {
    World world = scenes::empty();
    world.edit_definition().kinds[0].restitution = 0.4;
    add_ball(world, {.position = {0, 0}, .velocity = {}, .restitution = 1.0});
    CHECK_FALSE(world.model().inelastic);
    add_ball(world, {.position = {9, 0}, .velocity = {}});
    CHECK(world.balls().restitution == std::vector<double>{1.0, 0.4});
}

TEST_CASE("the fingerprint sees every bit that moves") {
    World world = scenes::gas(20, 1);
    const std::uint64_t before = fingerprint(world);
    std::set<std::uint64_t> seen{before};
    World other = world;
    other.edit_balls().position[7].x = std::nextafter(other.balls().position[7].x, 1e9);
    CHECK(seen.insert(fingerprint(other)).second);
    other = world;
    other.edit_balls().velocity[19].y = -other.balls().velocity[19].y;
    CHECK(seen.insert(fingerprint(other)).second);
    other = world;
    ++other.edit_tick();
    CHECK(seen.insert(fingerprint(other)).second);
    other = world;
    other.edit_capsules().shape[2].end.x += 1e-9;
    CHECK(seen.insert(fingerprint(other)).second);
    other = world;
    std::swap(other.edit_balls().position[3], other.edit_balls().position[4]);
    CHECK(seen.insert(fingerprint(other)).second);
    other = world;
    CHECK(fingerprint(other) == before);
    CHECK(hexadecimal(0x1f) == "000000000000001f");
}

TEST_CASE("totals of a known world") {
    World world = scenes::empty();
    world.edit_definition().model.gravity = Vec2{0, -10};
    add_ball(world, {.position = {2, 3}, .velocity = {1, 2}, .mass = 4.0});
    add_ball(world, {.position = {-1, 0}, .velocity = {0, -3}, .mass = 2.0});
    const Totals t = totals(world);
    CHECK(t.kinetic_energy == 0.5 * 4 * 5 + 0.5 * 2 * 9);
    CHECK(t.potential_energy == 4 * 10 * 3);
    CHECK(t.momentum == Vec2{4, 2});
    CHECK(t.angular_momentum == 4 * (2 * 2 - 3 * 1) + 2 * (-1 * -3));
}

TEST_CASE("the deepest overlap agrees with a test of every pair") {
    for (const bool torus : {false, true}) {
        World world = scenes::gas(200, 4, torus);
        for (double& radius : world.edit_balls().radius)
            radius *= 1.4;
        double deepest = 0.0;
        const Vec2 size_of_torus = torus ? size(*world.model().wrap) : Vec2{1e9, 1e9};
        for (std::size_t i = 0; i < 200; ++i)
            for (std::size_t j = 0; j < i; ++j)
                deepest =
                    std::max(deepest, 2.8 - length(nearest_image(world.balls().position[i] -
                                                                     world.balls().position[j],
                                                                 size_of_torus)));
        CHECK(deepest > 0.1);
        const double by_cells = deepest_overlap(world);
        CHECK(by_cells >= deepest - 1e-12);  // edges may be deeper
        if (torus) CHECK(by_cells == doctest::Approx(deepest).epsilon(1e-12));
    }
}

TEST_CASE("random numbers are uniform, and each purpose has its own stream") {
    double sum = 0.0;
    double squares = 0.0;
    constexpr int count = 100'000;
    for (int i = 0; i < count; ++i) {
        const double x = random_unit(42, RandomStream::fill, 3, static_cast<std::uint64_t>(i));
        CHECK_MESSAGE((x >= 0.0 && x < 1.0), "out of range");
        sum += x;
        squares += x * x;
    }
    // Four standard deviations.
    CHECK(sum / count == doctest::Approx(0.5).epsilon(4 * 0.5774 / 316.2));
    CHECK(squares / count == doctest::Approx(1.0 / 3).epsilon(0.012));
    CHECK(random_bits(1, RandomStream::fill, 2, 3) != random_bits(1, RandomStream::scatter, 2, 3));
    CHECK(random_bits(1, RandomStream::fill, 2, 3) != random_bits(1, RandomStream::fill, 3, 2));
    CHECK(random_bits(1, RandomStream::fill, 2, 3) != random_bits(2, RandomStream::fill, 2, 3));
    CHECK(random_bits(1, RandomStream::fill, 2, 3) == random_bits(1, RandomStream::fill, 2, 3));
}

TEST_CASE("a census counts the balls that are now in a zone") {
    World world = scenes::empty();
    world.edit_ledger().counters = {0, 0};
    world.edit_definition().zones.push_back({{{0, 0}, {0, 10}, 2}, Zone::Effect::census, 0});
    world.edit_definition().zones.push_back({{{4, 0}, {4, 10}, 2}, Zone::Effect::census, 1});
    add_ball(world, {.position = {1, 5}, .velocity = {}});
    add_ball(world, {.position = {5, 5}, .velocity = {}});
    add_ball(world, {.position = {4, 1}, .velocity = {}});
    add_ball(world, {.position = {40, 1}, .velocity = {}});
    CHECK(census(world) == std::vector<std::uint64_t>{1, 2});
    CHECK(world.ledger().counters == std::vector<std::uint64_t>{0, 0});
}
