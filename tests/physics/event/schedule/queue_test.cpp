#include "physics/event/schedule/queue.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

// Pseudo-random numbers, equal on every machine.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double unit() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }
    std::uint32_t below(std::size_t count) {
        return static_cast<std::uint32_t>(unit() * static_cast<double>(count));
    }

  private:
    std::uint64_t state_;
};

// The reference: checks all balls.
class SlowQueue {
  public:
    explicit SlowQueue(std::vector<double> times) : times_(std::move(times)) {}
    void update(std::uint32_t ball, double time) { times_[ball] = time; }
    double time(std::uint32_t ball) const { return times_[ball]; }
    std::optional<std::uint32_t> first() const {
        const auto least = std::min_element(times_.begin(), times_.end());
        if (least == times_.end() || !(*least < EventQueue::never)) return std::nullopt;
        return static_cast<std::uint32_t>(least - times_.begin());
    }

  private:
    std::vector<double> times_;
};

const auto by_number = [](std::uint32_t a, std::uint32_t b) { return a < b; };

}  // namespace

TEST_CASE("event queue: the first event is found, however the times are distributed") {
    // The time from the first event to a ball's next one.
    const auto wait = [](int kind, Dice& dice) {
        const double unit = dice.unit();
        switch (kind) {
            case 0:
                return 0.1 + unit;
            case 1:  // many at one time
                return static_cast<double>(static_cast<int>(4.0 * unit));
            case 2:  // over twelve orders of magnitude
                return 1e-9 / (1e-12 + unit * unit * unit * unit);
            case 3:  // some balls never have another event
                return unit < 0.25 ? EventQueue::never : unit;
            default:  // all at the same time
                return 0.0;
        }
    };
    for (const std::size_t count : {1u, 2u, 7u, 300u, 2'000u, 10'000u}) {
        for (int kind = 0; kind < 5; ++kind) {
            CAPTURE(count);
            CAPTURE(kind);
            Dice dice(count * 8 + static_cast<std::uint64_t>(kind));
            std::vector<double> times(count);
            for (double& time : times)
                time = wait(kind, dice);
            SlowQueue slow(times);
            EventQueue queue;
            queue.build(
                count, [&](std::uint32_t ball) { return times[ball]; }, by_number);
            for (int i = 0; i < 1'500; ++i) {
                const auto first = queue.first(by_number);
                REQUIRE(first == slow.first());
                if (!first) break;
                const double now = slow.time(*first);
                const auto change = [&](std::uint32_t ball) {
                    const double time = now + wait(kind, dice);
                    queue.update(ball, time, by_number);
                    slow.update(ball, time);
                };
                change(*first);
                change(dice.below(count));
            }
        }
    }
}

TEST_CASE("event queue: it adapts to events that become rare, and frequent again") {
    constexpr std::size_t count = 500;
    Dice dice(1);
    std::vector<double> times(count);
    for (double& time : times)
        time = dice.unit();
    SlowQueue slow(times);
    EventQueue queue;
    queue.build(
        count, [&](std::uint32_t ball) { return times[ball]; }, by_number);
    double now = 0.0;
    for (const double pause : {1.0, 1e6, 1e-6, 1e3, 1e-12, 1.0}) {
        CAPTURE(pause);
        for (int i = 0; i < 3'000; ++i) {
            const auto first = queue.first(by_number);
            REQUIRE(first);
            REQUIRE(first == slow.first());
            REQUIRE(slow.time(*first) >= now);
            now = slow.time(*first);
            const double time = now + pause * dice.unit();
            queue.update(*first, time, by_number);
            slow.update(*first, time);
        }
    }
}

// More balls than there are lists, for long enough that far events move up; and more replaced
// events than there is capacity for.
TEST_CASE("event queue: many balls, many of whose events are replaced long before they come") {
    constexpr std::size_t count = 6'000;
    using Timed = std::pair<double, std::uint32_t>;
    Dice dice(1);
    std::vector<double> times(count);
    std::set<Timed> sorted;
    const auto wait = [&dice] {
        const double unit = dice.unit();
        return unit < 0.05 ? 100.0 * unit : unit;
    };
    for (std::uint32_t ball = 0; ball < count; ++ball)
        sorted.emplace(times[ball] = wait(), ball);
    EventQueue queue;
    queue.build(
        count, [&](std::uint32_t ball) { return times[ball]; }, by_number);
    const auto change = [&](std::uint32_t ball, double time) {
        sorted.erase({times[ball], ball});
        sorted.emplace(times[ball] = time, ball);
        queue.update(ball, time, by_number);
    };
    for (int i = 0; i < 60'000; ++i) {
        const auto first = queue.first(by_number);
        REQUIRE(first == sorted.begin()->second);
        const double now = times[*first];
        change(*first, now + wait());
        for (int j = 0; j < 3; ++j)
            change(dice.below(count), now + wait());
    }
}

TEST_CASE("event queue: the prefetch cursor names nearly every ball some events before its turn") {
    constexpr std::size_t count = 3'000;
    Dice dice(1);
    std::vector<double> times(count);
    for (double& time : times)
        time = dice.unit();
    EventQueue queue;
    queue.build(
        count, [&](std::uint32_t ball) { return times[ball]; }, by_number);
    constexpr int never_told = -1;
    std::vector<int> told(count, never_told);
    constexpr int events = 30'000;
    int tellings = 0;
    int in_time = 0;
    for (int i = 0; i < events; ++i) {
        if (const auto ball = queue.next_to_prefetch()) {
            REQUIRE(*ball < count);
            told[*ball] = i;
            ++tellings;
        }
        const auto first = queue.first(by_number);
        REQUIRE(first);
        const int ahead = i - told[*first];
        in_time += told[*first] != never_told && ahead >= 4 && ahead <= 100;
        told[*first] = never_told;
        times[*first] += 2.0 * dice.unit();
        queue.update(*first, times[*first], by_number);
        // The event of another ball changes too.
        const std::uint32_t other = dice.below(count);
        times[other] = times[*first];
        queue.update(other, times[other], by_number);
    }
    CHECK(in_time > events * 8 / 10);
    CHECK(tellings < events * 12 / 10);
}

// Regression: after a rebuild in the middle of a tick the first ball was wrong if another ball's
// event was replaced before the first query.
TEST_CASE("event queue: rebuilt, an event replaced before the first query waits") {
    EventQueue queue;
    std::vector<double> times{100.0, 200.0, 300.0};
    const auto time_of = [&](std::uint32_t ball) { return times[ball]; };
    queue.build(3, time_of, by_number);
    REQUIRE(queue.first(by_number) == 0u);
    times = {7.0, 8.0, 9.0};
    queue.build(3, time_of, by_number);
    queue.update(1, 8.5, by_number);
    CHECK(queue.first(by_number) == 0u);
}

// Few events in a group of bins make the queue choose bins anew, at the border to the next group.
// The bin behind the border is then the present one, and has not been taken yet.
TEST_CASE("event queue: an event in the first bin of a group survives a new choice of bins") {
    // 64 bins of 1 s: the last event is in the first bin of the second group.
    std::vector<double> times{0.0, 0.5, 1.0, 64.5};
    EventQueue queue;
    queue.build(
        times.size(), [&](std::uint32_t ball) { return times[ball]; }, by_number);
    for (const std::uint32_t ball : {0u, 1u, 2u}) {
        REQUIRE(queue.first(by_number) == ball);
        queue.update(ball, EventQueue::never, by_number);
    }
    CHECK(queue.first(by_number) == 3u);
}

TEST_CASE("event queue: without balls, and without events") {
    EventQueue queue;
    queue.build(
        0, [](std::uint32_t) { return 0.0; }, by_number);
    CHECK(!queue.first(by_number));
    CHECK(!queue.next_to_prefetch());
    queue.build(
        3, [](std::uint32_t) { return EventQueue::never; }, by_number);
    CHECK(!queue.first(by_number));
    queue.update(1, 5.0, by_number);
    CHECK(queue.first(by_number) == 1u);
    queue.update(1, EventQueue::never, by_number);
    CHECK(!queue.first(by_number));
}
