#include "physics/event/schedule/time_bins.h"

#include <limits>

#include <doctest/doctest.h>

using namespace carom;

namespace {

std::vector<QueuedEvent> evenly_spread(std::uint32_t count, double begin, double end) {
    std::vector<QueuedEvent> events;
    for (std::uint32_t ball = 0; ball < count; ++ball)
        events.push_back({begin + (end - begin) * ball / count, ball, 1});
    return events;
}

}  // namespace

TEST_CASE("time bins: the first event is in bin 0, and about as many bins reach as events") {
    TimeBins bins;
    for (const std::uint32_t count : {1u, 100u, 5'000u, 100'000u}) {
        CAPTURE(count);
        auto events = evenly_spread(count, 3.0, 4.0);
        bins.reset();
        bins.choose(events);
        CHECK(bins.at(3.0) == 0.0);
        CHECK(bins.at(2.0) < 0.0);
        CHECK(bins.present() == 0);
        CHECK(bins.is_present(bins.at(3.0)));
        CHECK(bins.count() >= count);
        CHECK(bins.count() <= 2 * std::max(count, TimeBins::least_count));
        CHECK(bins.bins_a_group() * bins.groups() >= bins.count());
        CHECK(2 * bins.bins_a_group() <= 2 * TimeBins::most_listed);
    }
}

TEST_CASE("time bins: lists reach to the end of the next group, buckets once round") {
    auto events = evenly_spread(100'000, 0.0, 1.0);
    TimeBins bins;
    bins.choose(events);
    const std::uint64_t length = bins.bins_a_group();
    CHECK(bins.next_group() == length);
    CHECK(bins.lists_end() == 2 * length);
    const auto last = static_cast<double>(length * bins.groups());
    CHECK(!bins.is_far(last - 0.5));
    CHECK(bins.is_far(last));

    bins.go_to(length);
    CHECK(bins.begin_group() == 1);
    CHECK(bins.next_group() == 2 * length);
    CHECK(bins.lists_end() == 3 * length);
    CHECK(!bins.is_far(last));
    CHECK(bins.is_far(last + static_cast<double>(length)));
    CHECK(bins.group_of(2 * length - 1) == 1);
    CHECK(bins.group_of(2 * length) == 2);
}

TEST_CASE("time bins: what comes before the present bin is present") {
    auto events = evenly_spread(100, 0.0, 1.0);
    TimeBins bins;
    bins.choose(events);
    bins.go_to(5);
    CHECK(bins.is_present(-100.0));
    CHECK(bins.is_present(5.9));
    CHECK(!bins.is_present(6.0));
    CHECK(bins.whole(-100.0) == 5);
    CHECK(bins.whole(5.9) == 5);
    CHECK(bins.whole(7.5) == 7);
    CHECK(bins.is_far(std::numeric_limits<double>::infinity()));
}

TEST_CASE("time bins: events at one time, or none, leave a width that can be divided by") {
    TimeBins bins;
    auto events = evenly_spread(10, 2.0, 2.0);
    bins.choose(events);
    CHECK(bins.at(2.0) == 0.0);
    CHECK(bins.at(3.0) == 1.0);
    events.clear();
    bins.choose(events);
    CHECK(bins.at(3.0) == 1.0);
}
