#include "physics/event/motion/stored_trajectory.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("stored trajectory: a linear trajectory is restored completely") {
    LinearPart<double> line;
    line.recent_collisions = 65'535;
    line.motion = Motion::sliding;
    line.time = 1.5;
    line.position = {2.0, -3.0};
    line.velocity = {-4.0, 5.0};
    const StoredLinearPart stored = stored_linear_part(BallId{7}, line);
    const Trajectory<double> back = trajectory_from(stored, {});
    CHECK(back.recent_collisions == line.recent_collisions);
    CHECK(back.motion == line.motion);
    CHECK(back.time == line.time);
    CHECK(Vec2(back.position) == Vec2(line.position));
    CHECK(Vec2(back.velocity) == Vec2(line.velocity));
}
