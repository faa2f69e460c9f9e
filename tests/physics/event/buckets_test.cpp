#include "physics/event/buckets.h"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

std::vector<std::uint32_t> taken_from(EventBags& bags, std::size_t bag) {
    std::vector<std::uint32_t> balls;
    bags.empty(bag, [&](const QueuedEvent& event) {
        CHECK(event.time == event.ball * 0.5);
        CHECK(event.stamp == event.ball + 1);
        balls.push_back(event.ball);
    });
    std::sort(balls.begin(), balls.end());
    return balls;
}

}  // namespace

TEST_CASE("event bags: what was put into a bag comes out of it, once") {
    constexpr std::size_t bag_count = 7;
    constexpr std::uint32_t most = 1'000;
    EventBags bags;
    bags.reset(bag_count, most);
    // Full to the last, and time and again: what one bag gives back, the next takes.
    for (std::uint32_t round = 0; round < 20; ++round) {
        CAPTURE(round);
        std::vector<std::vector<std::uint32_t>> put(bag_count);
        for (std::uint32_t ball = 0; ball < most; ++ball) {
            const std::size_t bag = (ball * ball / 3 + round) % bag_count;
            bags.add(bag, {ball * 0.5, ball, ball + 1});
            put[bag].push_back(ball);
        }
        CHECK(bags.size() == most);
        for (std::size_t bag = 0; bag < bag_count; ++bag)
            REQUIRE(taken_from(bags, bag) == put[bag]);
        CHECK(bags.size() == 0);
        CHECK(taken_from(bags, 0).empty());
    }
}

TEST_CASE("event bags: a bag that is being emptied can be filled") {
    EventBags bags;
    bags.reset(2, 200);
    for (std::uint32_t ball = 0; ball < 200; ++ball)
        bags.add(0, {ball * 0.5, ball, ball + 1});
    std::uint32_t told = 0;
    bags.empty(0, [&](const QueuedEvent& event) {
        ++told;
        bags.add(event.ball % 2, event);
    });
    CHECK(told == 200);
    CHECK(bags.size() == 200);
    CHECK(taken_from(bags, 0).size() == 100);
    CHECK(taken_from(bags, 1).size() == 100);
}
