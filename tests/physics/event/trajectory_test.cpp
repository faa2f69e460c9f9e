#include "physics/event/trajectory.h"

#include <doctest/doctest.h>

#include <vector>

using namespace carom;

TEST_CASE("event paths: what a world keeps of a line is all of it, and its sum tells lines apart") {
    EventLine<double> line;
    line.quick = 65'535;
    line.motion = Motion::sliding;
    line.time = 1.5;
    line.position = {2.0, -3.0};
    line.velocity = {-4.0, 5.0};
    const BallPath stored = stored_line(BallId{7}, line);
    const EventPath<double> back = path_from(stored, {});
    CHECK(back.quick == line.quick);
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

TEST_CASE("event paths: impacts in a row are counted as far as a world can keep") {
    CHECK(one_more(0) == 1);
    CHECK(one_more(65'534) == 65'535);
    CHECK(one_more(65'535) == 65'535);
}
