#include "physics/event/motion/trajectory.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("trajectory: recent collisions are counted as far as a world can store") {
    CHECK(one_more(0) == 1);
    CHECK(one_more(65'534) == 65'535);
    CHECK(one_more(65'535) == 65'535);
}

// Regression: the series of a piece diverged where drag was strong against the time of the piece,
// and threw the ball out of the scene.
TEST_CASE("trajectory: a ball that turns under strong drag goes at the speed that drag leaves it") {
    Field<double> field;
    field.gravity = {0.0, -1.0};
    field.has_drag = true;
    for (const double drag : {1.0, 100.0, 1e5, 1e9}) {
        CAPTURE(drag);
        field.drag = drag;
        Trajectory<double> trajectory;
        trajectory.motion = Motion::turning;
        trajectory.center = {0.0, 0.0};
        trajectory.position = {0.6, 0.8};
        for (int piece = 0; piece < 40; ++piece) {
            const double end = piece_end(trajectory, field);
            REQUIRE(end > trajectory.time);
            const BallState<double> state = state_at(trajectory, field, end);
            CHECK(length(state.position) == doctest::Approx(1.0).epsilon(1e-12));
            // Gravity along the circle, less than 1, over drag.
            CHECK(length(state.velocity) < 1.0 / drag);
            trajectory.position = state.position;
            trajectory.velocity = state.velocity;
            trajectory.time = end;
        }
        if (drag > 1.0) CHECK(length(trajectory.velocity) > 0.5 / drag);
    }
}
