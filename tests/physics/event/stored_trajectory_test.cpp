#include "physics/event/stored_trajectory.h"

#include <vector>

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("stored trajectory: a line comes back whole, and its digest tells lines apart") {
    LinearPart<double> line;
    line.recent_collisions = 65'535;
    line.motion = Motion::sliding;
    line.time = 1.5;
    line.position = {2.0, -3.0};
    line.velocity = {-4.0, 5.0};
    const BallPath stored = stored_line(BallId{7}, line);
    const Trajectory<double> back = path_from(stored, {});
    CHECK(back.recent_collisions == line.recent_collisions);
    CHECK(back.motion == line.motion);
    CHECK(back.time == line.time);
    CHECK(Vec2(back.position) == Vec2(line.position));
    CHECK(Vec2(back.velocity) == Vec2(line.velocity));

    std::vector<BallPath> others(8, stored);
    others[0].id = BallId{8};
    others[1].quick = 0;
    others[2].motion = Motion::free;
    others[3].time = -1.5;
    others[4].position.x = -2.0;
    others[5].position.y = 3.0;
    others[6].velocity = {5.0, -4.0};
    others[7].velocity.y = -5.0;
    for (const BallPath& other : others)
        CHECK(sum_of(other) != sum_of(stored));
}
