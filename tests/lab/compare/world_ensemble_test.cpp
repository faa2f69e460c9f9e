#include "lab/compare/world_ensemble.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/measure/difference.h"
#include "level/load.h"
#include "physics/world/fingerprint.h"

using namespace carom;

namespace {

World pegs_and_ball() {
    const LoadResult result = load_level(
        "carom 1 \"Sinai\"\n"
        "box 0,0 40,40\n"
        "peg at=20,20 r=8\n"
        "ball a at=5,6 v=30,17 r=1\n"
        "ball b at=33,34 v=-11,23 r=1\n",
        "sinai.level");
    REQUIRE(result.scene.has_value());
    return result.scene->world;
}

double spread_of(const WorldEnsemble& butterfly) {
    double most = 0.0;
    for (const World& world : butterfly.copies())
        most = std::max(most, difference(butterfly.copies().front(), world).max);
    return most;
}

std::uint64_t sum(const Density& grid) {
    return std::accumulate(grid.counts.begin(), grid.counts.end(), std::uint64_t{0});
}

}  // namespace

TEST_CASE("copies start close to the first, which is the world itself, and diverge") {
    const World start = pegs_and_ball();
    WorldEnsemble butterfly(start, {}, {.copies = 200, .size = 1e-6, .seed = 5});
    CHECK(butterfly.copies().size() == 200);
    CHECK(butterfly.copies()[0].balls().position == start.balls().position);
    CHECK(spread_of(butterfly) <= 1.5e-6);
    CHECK(difference(butterfly.copies()[1], butterfly.copies()[2]).max > 0.0);
    for (int i = 0; i < 1200; ++i)
        butterfly.step();
    CHECK(butterfly.time() == doctest::Approx(10.0));
    CHECK(spread_of(butterfly) > 1.0);

    World alone = start;
    Solver solver{SolverSettings{}};
    for (int i = 0; i < 1200; ++i)
        solver.tick(alone);
    CHECK(fingerprint(alone) == fingerprint(butterfly.copies()[0]));
}

TEST_CASE("a seed determines the copies, and another seed gives others") {
    const World start = pegs_and_ball();
    const auto last = [&](std::uint64_t seed) {
        WorldEnsemble butterfly(start, {}, {.copies = 3, .size = 1e-3, .seed = seed});
        for (int i = 0; i < 10; ++i)
            butterfly.step();
        return fingerprint(butterfly.copies()[2]);
    };
    CHECK(last(1) == last(1));
    CHECK(last(1) != last(2));
}

TEST_CASE("the density counts every ball in view once") {
    World world = pegs_and_ball();
    world.edit_balls().position = {{0, 0}, {39.9, 39.9}};
    const std::vector<World> copies{world, world, world};
    const Box view{{0, 0}, {40, 40}};
    const Density grid = density(copies, view, 8, 4);
    CHECK(sum(grid) == 6);
    CHECK(grid.at(0, 3) == 3);
    CHECK(grid.at(7, 0) == 3);
    CHECK(sum(density(copies, view, 8, 4, BallId{1})) == 3);
    CHECK(density(copies, view, 8, 4, BallId{1}).at(7, 0) == 3);
    CHECK(sum(density(copies, view, 8, 4, BallId{9})) == 0);
    CHECK(sum(density(copies, {{0, 0}, {39.9, 39.9}}, 8, 4)) == 3);
}

TEST_CASE("an interrupted step continues where it stopped, to the same bits") {
    const World start = pegs_and_ball();
    WorldEnsemble at_once(start, {}, {.copies = 10, .size = 1e-6, .seed = 5});
    WorldEnsemble in_bits(start, {}, {.copies = 10, .size = 1e-6, .seed = 5});
    for (int i = 0; i < 50; ++i) {
        CHECK(at_once.step());
        int asked = 0;
        while (!in_bits.step([&] { return ++asked % 3 != 0; })) {
        }
        CHECK(asked == 9);
    }
    for (std::size_t i = 0; i < 10; ++i)
        CHECK(fingerprint(at_once.copies()[i]) == fingerprint(in_bits.copies()[i]));
}

TEST_CASE("the spread is the root mean square distance of the worst ball, in its radii") {
    World start = pegs_and_ball();
    start.edit_balls().radius[1] = 0.5;
    const WorldEnsemble butterfly(start, {}, {.copies = 5, .size = 1e-3, .seed = 5});
    double most = 0.0;
    for (std::size_t ball = 0; ball < 2; ++ball) {
        double sum = 0.0;
        for (const World& copy : butterfly.copies())
            sum += length_squared(copy.balls().position[ball] - start.balls().position[ball]);
        most = std::max(most, std::sqrt(sum / 4.0) / start.balls().radius[ball]);
    }
    CHECK(butterfly.spread() == doctest::Approx(most).epsilon(1e-12));
    CHECK(WorldEnsemble(start, {}, {.copies = 1}).spread() == 0.0);
}

TEST_CASE("every copy executes commands, and changes its solver") {
    const World start = pegs_and_ball();
    WorldEnsemble butterfly(start, {}, {.copies = 3});
    butterfly.execute(command::RemoveBall{BallId{0}});
    butterfly.execute(command::SetSolver{{.kind = SolverKind::discrete}});
    World alone = butterfly.copies()[2];
    CHECK(alone.balls().size() == 1);
    Solver solver({.kind = SolverKind::discrete});
    for (int i = 0; i < 300; ++i) {
        butterfly.step();
        solver.tick(alone);
    }
    CHECK(fingerprint(alone) == fingerprint(butterfly.copies()[2]));
}
