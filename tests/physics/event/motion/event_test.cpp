#include "physics/event/motion/event.h"

#include <vector>

#include <doctest/doctest.h>

using namespace carom;
using Event = BallEvent<double>;

namespace {

struct Owned {
    std::uint32_t ball;
    Event event;
};

// Ascending in the order of events.
const std::vector<Owned> ascending{
    {5, {1.0, EventKind::cell_transfer, 0, 0, 0, 0}},
    {2, {2.0, EventKind::ball_ball, 0, 0, 7, 0}},
    {7, {2.0, EventKind::ball_ball, 0, 0, 2, 0}},  // the same pair, seen from the other ball
    {3, {2.0, EventKind::ball_ball, 0, 0, 4, 0}},
    {0, {2.0, EventKind::ball_edge, 0, 0, 0, 0}},
    {0, {2.0, EventKind::kinematic_edge, 0, 0, 0, 0}},
    {0, {2.0, EventKind::transition, 0, 0, 0, 0}},
    {0, {2.0, EventKind::cell_transfer, 0, 0, 1, 0}},
    {0, {3.0, EventKind::ball_ball, 0, 0, 1, 0}},
    {0, {0.0, EventKind::none, 0, 0, 0, 0}},
    {1, {0.0, EventKind::none, 0, 0, 0, 0}},
};

}  // namespace

TEST_CASE("event: the order of events is total") {
    for (std::size_t i = 0; i < ascending.size(); ++i)
        for (std::size_t j = 0; j < ascending.size(); ++j) {
            CAPTURE(i);
            CAPTURE(j);
            CHECK(comes_before(ascending[i].ball, ascending[i].event, ascending[j].ball,
                               ascending[j].event) == (i < j));
        }
}

TEST_CASE("event: the earlier event is kept, whichever is offered first") {
    const Event early{1.0, EventKind::ball_edge, 0, 0, 3, 0};
    const Event late{2.0, EventKind::ball_ball, 0, 0, 4, 0};
    const Event as_early{1.0, EventKind::ball_ball, 0, 0, 4, 0};
    for (const bool swapped : {false, true}) {
        Event best;
        keep_earlier(0, swapped ? late : early, best);
        keep_earlier(0, swapped ? early : late, best);
        CHECK(best.kind == EventKind::ball_edge);
        keep_earlier(0, as_early, best);
        CHECK(best.kind == EventKind::ball_ball);
        keep_earlier(0, Event{}, best);
        CHECK(best.kind == EventKind::ball_ball);
    }
}
