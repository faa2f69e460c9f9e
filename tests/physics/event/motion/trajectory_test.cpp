#include "physics/event/motion/trajectory.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("trajectory: recent collisions are counted as far as a world can store") {
    CHECK(one_more(0) == 1);
    CHECK(one_more(65'534) == 65'535);
    CHECK(one_more(65'535) == 65'535);
}
