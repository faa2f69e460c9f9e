#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "geometry/elementary.h"
#include "level/load.h"

// `seesaw`: what the loader makes of it. tests/level/broken/seesaws.level has the errors.

using namespace carom;

namespace {

Scene seesaws_of(const std::string& text) {
    LoadResult result =
        load_level("carom 1 \"Seesaws\"\n" + text + "ball a at=900,900 r=1\n", "s.level");
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.severity == Severity::error) FAIL(render(diagnostic));
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

}  // namespace

TEST_CASE("seesaws: a bar on a hinge, tilted from where it is drawn") {
    const Scene scene = seesaws_of(
        "edge name=other 0,0 1,0\n"
        "edge name=plank 10,10 22,10 r=1\n"
        "seesaw plank about=14,10 m=3 from=-20 to=30 e=0.25 tilt=15 turning=2\n");
    const World& world = scene.world;
    CHECK(world.model().hinged);
    REQUIRE(world.seesaws().size() == 1);
    const Seesaw& seesaw = world.seesaws()[0];
    CHECK(seesaw.capsule == world.capsules().id[1]);
    CHECK(seesaw.home == Capsule{{10.0, 10.0}, {22.0, 10.0}, 1.0});
    CHECK(seesaw.pivot == Vec2{14.0, 10.0});
    // (4^3 + 8^3) / (3 (4 + 8)) for each unit of mass.
    CHECK(seesaw.inertia == doctest::Approx(3.0 * 576.0 / 36.0));
    CHECK(seesaw.least == doctest::Approx(-20.0 * pi / 180.0));
    CHECK(seesaw.most == doctest::Approx(30.0 * pi / 180.0));
    CHECK(seesaw.stop_restitution == 0.25);
    CHECK(seesaw.angle == doctest::Approx(15.0 * pi / 180.0));
    CHECK(seesaw.rate == 2.0);
    CHECK(world.capsules().shape[1] == seesaw_shape(seesaw, seesaw.angle));
    CHECK(moves_by_itself(world, seesaw.capsule));
    CHECK_FALSE(moves_by_itself(world, world.capsules().id[0]));
}

TEST_CASE("seesaws: units, no stops, and a change of the tilt") {
    const Scene scene = seesaws_of(
        "units cm\n"
        "edge name=bar 0,0 0,100\n"
        "seesaw bar about=0,50 m=600g turning=90deg/s\n"
        "move bar tilt=-45deg turning=-1rad/s\n");
    const Seesaw& seesaw = scene.world.seesaws().at(0);
    CHECK(seesaw.inertia == doctest::Approx(0.6 / 12.0));
    CHECK(seesaw.angle == doctest::Approx(-pi / 4.0));
    CHECK(seesaw.rate == doctest::Approx(-1.0));
    CHECK(seesaw.most > 1e300);
    CHECK(seesaw.least < -1e300);
    CHECK(length(scene.world.capsules().shape[0].end -
                 Vec2{0.5 * std::sqrt(0.5), 0.5 + 0.5 * std::sqrt(0.5)}) < 1e-12);
}
