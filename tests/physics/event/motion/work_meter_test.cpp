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
    work.begin(keep_going, 1);
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
    work.begin(nobody, 1);
    work.count_rounds(2 * events_between_polls);
    CHECK(work.may_go_on());
}

TEST_CASE("event work meter: a repeated tick spends what the first trial left of the budget") {
    WorkMeter<double> meter;
    const std::function<bool()> never_asked;
    const std::uint64_t budget = event_budget.per_ball * event_budget.least_balls;
    const auto is_over_after = [&](std::uint64_t rounds) {
        meter.count_rounds(rounds);
        CHECK(meter.may_go_on());
        return meter.is_over_budget();
    };
    meter.begin(never_asked, 1, true);
    CHECK(!is_over_after(budget / 2));
    meter.begin(never_asked, 1, true);
    CHECK(is_over_after(budget / 2 + 1));
    meter.begin(never_asked, 1);
    CHECK(!is_over_after(budget / 2));
    // What an earlier tick has used does not count.
    meter.forget_trials();
    meter.begin(never_asked, 1, true);
    CHECK(!is_over_after(budget / 2 + 1));
}

TEST_CASE("event work meter: over the budget, each ball has a share") {
    WorkMeter<double> meter;
    const std::function<bool()> never_asked;
    const std::size_t balls = 2 * event_budget.least_balls;
    meter.begin(never_asked, balls);
    meter.count_rounds(event_budget.per_ball * balls);
    CHECK(meter.may_go_on());
    CHECK(!meter.is_over_budget());
    meter.count_rounds(events_between_polls);
    CHECK(meter.may_go_on());
    CHECK(meter.is_over_budget());
    CHECK(meter.take_uncharged() == 0);
    meter.count_event();
    meter.count_rounds(event_budget.per_ball - 1);
    const std::uint64_t work = meter.take_uncharged();
    CHECK(work == event_budget.per_ball);
    CHECK(!meter.charge(0, work));
    CHECK(!meter.charge(1, work));
    CHECK(meter.charge(1, 1));
    meter.begin(never_asked, balls);
    CHECK(!meter.is_over_budget());
}
