#include "physics/event/schedule/buckets.h"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

std::vector<std::uint32_t> taken_from(EventBuckets& buckets, std::size_t bucket) {
    std::vector<std::uint32_t> balls;
    buckets.empty(bucket, [&](const QueuedEvent& event) {
        CHECK(event.time == event.ball * 0.5);
        CHECK(event.generation == event.ball + 1);
        balls.push_back(event.ball);
    });
    std::sort(balls.begin(), balls.end());
    return balls;
}

}  // namespace

TEST_CASE("event buckets: an event comes out of its bucket once") {
    constexpr std::size_t bucket_count = 7;
    constexpr std::uint32_t most = 1'000;
    EventBuckets buckets;
    buckets.reset(bucket_count, most);
    // Filled to capacity many times: each bucket reuses the chunks of others.
    for (std::uint32_t round = 0; round < 20; ++round) {
        CAPTURE(round);
        std::vector<std::vector<std::uint32_t>> put(bucket_count);
        for (std::uint32_t ball = 0; ball < most; ++ball) {
            const std::size_t bucket = (ball * ball / 3 + round) % bucket_count;
            buckets.add(bucket, {ball * 0.5, ball, ball + 1});
            put[bucket].push_back(ball);
        }
        CHECK(buckets.size() == most);
        for (std::size_t bucket = 0; bucket < bucket_count; ++bucket)
            REQUIRE(taken_from(buckets, bucket) == put[bucket]);
        CHECK(buckets.size() == 0);
        CHECK(taken_from(buckets, 0).empty());
    }
}

TEST_CASE("event buckets: a bucket that is being emptied can be filled") {
    EventBuckets buckets;
    buckets.reset(2, 200);
    for (std::uint32_t ball = 0; ball < 200; ++ball)
        buckets.add(0, {ball * 0.5, ball, ball + 1});
    std::uint32_t told = 0;
    buckets.empty(0, [&](const QueuedEvent& event) {
        ++told;
        buckets.add(event.ball % 2, event);
    });
    CHECK(told == 200);
    CHECK(buckets.size() == 200);
    CHECK(taken_from(buckets, 0).size() == 100);
    CHECK(taken_from(buckets, 1).size() == 100);
}
