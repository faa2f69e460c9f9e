#include "physics/event/schedule/event_heap.h"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

const auto lower_ball = [](std::uint32_t a, std::uint32_t b) { return a < b; };

double heap_time(std::uint32_t ball, std::uint32_t round) {
    return static_cast<double>((ball * 7919u + round * 104'729u) % 31u);  // many are equal
}

}  // namespace

TEST_CASE("event heap: entries come out in order, after additions, replacements and removals") {
    for (const std::uint32_t count : {1u, 2u, 5u, 6u, 40u, 333u}) {
        CAPTURE(count);
        EventHeap heap;
        EntryMarks marks;
        marks.reset(count);
        std::vector<EventHeap::Entry> expected;
        for (std::uint32_t ball = 0; ball < count; ++ball) {
            heap.add({heap_time(ball, 0), ball}, marks, lower_ball);
            REQUIRE(marks.is_in_heap(ball));
        }
        for (std::uint32_t ball = 0; ball < count; ++ball) {
            if (ball % 5 == 4) {
                heap.remove(marks.heap_index(ball), marks, lower_ball);
                marks.remove(ball);
                continue;
            }
            const double time = heap_time(ball, ball % 3);
            heap.replace(marks.heap_index(ball), {time, ball}, marks, lower_ball);
            expected.push_back({time, ball});
        }
        std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) {
            return a.time < b.time || (a.time == b.time && a.ball < b.ball);
        });
        for (const EventHeap::Entry& next : expected) {
            REQUIRE(!heap.is_empty());
            CHECK(heap.first().ball == next.ball);
            CHECK(heap.first().time == next.time);
            CHECK(marks.heap_index(next.ball) == 0);
            heap.remove(0, marks, lower_ball);
            marks.remove(next.ball);
        }
        CHECK(heap.is_empty());
    }
}

TEST_CASE("event heap: the last entry can be removed") {
    EventHeap heap;
    EntryMarks marks;
    marks.reset(2);
    heap.add({1.0, 0}, marks, lower_ball);
    heap.add({2.0, 1}, marks, lower_ball);
    heap.remove(1, marks, lower_ball);
    CHECK(heap.first().ball == 0);
    heap.remove(0, marks, lower_ball);
    CHECK(heap.is_empty());
}
