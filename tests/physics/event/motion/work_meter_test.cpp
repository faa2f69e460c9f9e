#include "physics/event/motion/work_meter.h"

#include <cstdint>
#include <functional>

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE(
    "work meter: it asks after a number of events, rounds or iterations, and stays cancelled") {
    int asked = 0;
    const std::function<bool()> keep_going = [&] { return ++asked < 3; };
    WorkMeter<double> work;
    work.begin(keep_going);
    CHECK(work.may_go_on());
    CHECK(asked == 0);
    for (std::uint64_t i = 0; i < events_between_polls; ++i)
        work.count_event();
    CHECK(work.may_go_on());
    CHECK(work.may_go_on());
    CHECK(asked == 1);
    work.search().iterations += events_between_polls * iterations_per_event;
    CHECK(work.may_go_on());
    CHECK(asked == 2);
    work.count_rounds(events_between_polls);
    CHECK(!work.may_go_on());
    CHECK(asked == 3);
    CHECK(!work.may_go_on());
    CHECK(work.is_cancelled());
    const std::function<bool()> nobody;
    work.begin(nobody);
    work.count_rounds(2 * events_between_polls);
    CHECK(work.may_go_on());
}
