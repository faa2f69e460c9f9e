#include "lab/observe/region.h"

#include <doctest/doctest.h>

#include "lab/support/load.h"

using namespace carom;

TEST_CASE("a region is what centres of balls can reach") {
    const auto region = [](const std::string& statements) {
        const Scene scene = test::load(statements);
        return region_of(scene, scene.world);
    };
    CHECK(region("box name=w 0,0 20,10 r=1\nball at=10,5 r=2\n")->area == doctest::Approx(14 * 4));
    CHECK(*region("box name=w 0,0 20,10 r=1\nball at=10,5 r=2\n")->sides == Vec2{14, 4});
    // A right triangle shrinks to the one whose incircle is smaller by the radius.
    const double incircle = 2.0;  // of sides 6, 8, 10
    CHECK(region("edge 0,0 8,0 0,6 close\nball at=2,2 r=1\n")->area ==
          doctest::Approx(24.0 / (incircle * incircle)));
    CHECK_FALSE(region("edge 0,0 8,0 0,6 close\nball at=2,2 r=1\n")->sides);
    // The same, in the other direction.
    CHECK(region("edge 0,6 8,0 0,0 close\nball at=2,2 r=1\n")->area == doctest::Approx(6.0));
    // An L: 300 less the strips, more the square corners, less the quarter of a disc.
    CHECK(region("edge 0,0 20,0 20,10 10,10 10,20 0,20 close\nball at=5,5 r=1\n")->area ==
          doctest::Approx(300.0 - 80.0 + 5.0 - 3.14159265358979 / 4.0));
    CHECK(region("world 0,0 7,5\nuse wrap\nball at=1,1 r=1\n")->area == 35.0);
    CHECK_FALSE(region("ball at=1,1 r=1\n"));
    CHECK_FALSE(region("box name=w 0,0 20,10\nbox name=v 30,0 40,10\nball at=5,5\n"));
    CHECK_FALSE(region("box name=w 0,0 20,10\nball at=50,5\n"));
}
