#include "physics/swept/schedule.h"

#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

SweptEvent at(double time, std::uint32_t ball, std::uint32_t other) {
    return {.time = time, .ball = ball, .other = other, .normal = {}};
}

std::vector<double> drained_times(SweptSchedule& schedule) {
    std::vector<double> times;
    while (const auto event = schedule.take())
        times.push_back(event->time);
    return times;
}

}  // namespace

TEST_CASE("swept schedule: initial and later events come in one order of time") {
    SweptSchedule schedule;
    schedule.clear();
    for (const double time : {0.9, 0.1, 0.5, 0.11, 0.999})
        schedule.add_initial(at(time, 1, 2));
    schedule.sort_initial(1.0);
    schedule.push(at(0.6, 3, 4));
    schedule.push(at(0.05, 3, 4));
    CHECK(drained_times(schedule) == std::vector<double>{0.05, 0.1, 0.11, 0.5, 0.6, 0.9, 0.999});
    CHECK(!schedule.take());
}

TEST_CASE("swept schedule: at one time, lower numbers come first, whoever predicted") {
    SweptSchedule schedule;
    schedule.clear();
    schedule.add_initial(at(0.5, 7, 3));
    schedule.add_initial(at(0.5, 2, 9));
    schedule.sort_initial(1.0);
    schedule.push(at(0.5, 1, 8));
    schedule.push(at(0.5, 2, 10));
    CHECK(schedule.take()->ball == 1);
    CHECK(schedule.take()->other == 9);
    CHECK(schedule.take()->other == 10);
    CHECK(schedule.take()->ball == 7);
}

TEST_CASE("swept schedule: cleared, it holds nothing of an earlier substep") {
    SweptSchedule schedule;
    schedule.add_initial(at(0.5, 1, 2));
    schedule.sort_initial(1.0);
    schedule.push(at(0.6, 1, 2));
    schedule.clear();
    CHECK(!schedule.take());
    schedule.sort_initial(1.0);
    CHECK(!schedule.take());
}

TEST_CASE("swept schedule: what is upcoming counts from the next initial event") {
    SweptSchedule schedule;
    schedule.clear();
    for (const double time : {0.1, 0.2, 0.3})
        schedule.add_initial(at(time, 1, 2));
    schedule.sort_initial(1.0);
    CHECK(schedule.upcoming(0) == nullptr);
    schedule.take();
    REQUIRE(schedule.upcoming(1) != nullptr);
    CHECK(schedule.upcoming(1)->time == 0.3);
    CHECK(schedule.upcoming(2) == nullptr);
}
