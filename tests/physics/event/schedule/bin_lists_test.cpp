#include "physics/event/schedule/bin_lists.h"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

std::vector<std::uint32_t> balls_of(const BinLists& lists, std::uint64_t bin) {
    std::vector<std::uint32_t> balls;
    lists.for_each(bin, [&](const QueuedEvent& event) { balls.push_back(event.ball); });
    std::sort(balls.begin(), balls.end());
    return balls;
}

}  // namespace

TEST_CASE("bin lists: an event comes out of its bin once, and nodes are used again") {
    BinLists lists;
    lists.reset(64, 8);
    for (std::uint64_t round = 0; round < 50; ++round) {
        CAPTURE(round);
        const std::uint64_t first = round * 13;
        for (std::uint32_t ball = 0; ball < 100; ++ball)
            lists.add(first + ball % 50, {ball * 0.5, ball, ball + 1});
        CHECK(lists.size() == 100);
        for (std::uint64_t i = 0; i < 50; ++i) {
            std::vector<std::uint32_t> balls;
            lists.empty(first + i, [&](const QueuedEvent& event) {
                CHECK(event.time == event.ball * 0.5);
                CHECK(event.generation == event.ball + 1);
                balls.push_back(event.ball);
            });
            std::sort(balls.begin(), balls.end());
            CHECK(balls == std::vector<std::uint32_t>{static_cast<std::uint32_t>(i),
                                                      static_cast<std::uint32_t>(i) + 50});
            CHECK(balls_of(lists, first + i).empty());
        }
        CHECK(lists.size() == 0);
    }
}

TEST_CASE("bin lists: the next bin with entries is found, round the end of the lists too") {
    BinLists lists;
    lists.reset(128, 8);
    // 250 and 260 have lists 122 and 4.
    lists.add(250, {0.0, 0, 1});
    lists.add(260, {0.0, 1, 1});
    CHECK(lists.filled_from(200, 300) == 250);
    CHECK(lists.filled_from(250, 300) == 250);
    CHECK(lists.filled_from(251, 300) == 260);
    CHECK(lists.filled_from(251, 260) == 260);
    CHECK(lists.filled_from(251, 255) == 255);
    CHECK(lists.filled_from(261, 300) == 300);
    lists.empty(250, [](const QueuedEvent&) {});
    CHECK(lists.filled_from(200, 300) == 260);
}

TEST_CASE("bin lists: void entries are passed over") {
    EntryMarks marks;
    marks.reset(4);
    BinLists lists;
    lists.reset(64, 4);
    for (std::uint32_t ball = 0; ball < 4; ++ball)
        lists.add(7, {0.0, ball, marks.next_generation(ball)});
    marks.remove(3);
    marks.next_generation(1);
    const std::uint32_t first = lists.first_valid(7, marks);
    REQUIRE(first != BinLists::no_node);
    const std::uint32_t second = lists.next_valid(first, marks);
    REQUIRE(second != BinLists::no_node);
    CHECK(lists.ball(first) + lists.ball(second) == 2);
    CHECK(lists.next_valid(second, marks) == BinLists::no_node);
    CHECK(lists.first_valid(8, marks) == BinLists::no_node);
    CHECK(lists.size() == 4);
}
