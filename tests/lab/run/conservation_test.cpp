#include "lab/run/conservation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "level/load.h"

using namespace carom;

namespace {

World world_of(const std::string& statements) {
    LoadResult result = load_level("carom 1 \"A test\"\n" + statements, "test.level");
    REQUIRE(result.scene.has_value());
    return result.scene->world;
}

}  // namespace

TEST_CASE("in a conservative scene the largest change counts") {
    World world = world_of("ball a at=0,0 v=3,0 r=1 m=2\nball b at=9,0 v=-1,0 r=1 m=2\n");
    ConservationWatch watch(world);  // energy 10, sum of momenta 8
    world.edit_balls().velocity[0] = {2, 0};
    watch.note(world);
    CHECK(watch.energy_drift() == doctest::Approx(0.5));
    CHECK(watch.momentum_drift() == doctest::Approx(0.25));
    world.edit_balls().velocity[0] = {3, 0};
    watch.note(world);
    CHECK(watch.energy_drift() == doctest::Approx(0.5));
    world.edit_balls().velocity[0] = {std::numeric_limits<double>::quiet_NaN(), 0};
    watch.note(world);
    CHECK(std::isinf(*watch.energy_drift()));
    CHECK(std::isinf(*watch.momentum_drift()));
}

TEST_CASE("in a dissipative scene only a rise counts") {
    World world = world_of("use drag 0.1\nball a at=0,0 v=2,0\n");
    ConservationWatch watch(world);
    world.edit_balls().velocity[0] = {1, 0};
    watch.note(world);
    CHECK(watch.energy_drift() == 0.0);
    world.edit_balls().velocity[0] = {4, 0};
    watch.note(world);
    CHECK(watch.energy_drift() == doctest::Approx(0.75));
    CHECK(watch.momentum_drift() == std::nullopt);
}

TEST_CASE("in a scene that gains energy there is no drift") {
    const World world =
        world_of("world 0,0 9,9\nuse wrap\nuse gravity 0,-1\nball a at=5,5 v=2,0\n");
    CHECK(ConservationWatch(world).energy_drift() == std::nullopt);
}

TEST_CASE("a world at rest does not drift") {
    const World world = world_of("ball a at=0,0\n");
    ConservationWatch watch(world);
    watch.note(world);
    CHECK(watch.energy_drift() == 0.0);
    CHECK(watch.momentum_drift() == 0.0);
}
