#include "physics/ccd/impact_queue.h"

#include <tuple>
#include <vector>

#include <doctest/doctest.h>

using namespace carom;

namespace {

struct Event {
    double time = 0.0;
    int kind = 0;
    int low = 0;
    auto tie_break() const { return std::tuple(kind, low); }
    friend bool operator==(const Event&, const Event&) = default;
};

std::vector<Event> drained(ImpactQueue<Event>& queue) {
    std::vector<Event> events;
    while (!queue.is_empty()) {
        const Event first = queue.first();
        events.push_back(queue.pop());
        CHECK(events.back() == first);
    }
    return events;
}

}  // namespace

TEST_CASE("impact queue: earliest first, ties by kind and number, whatever the order of pushes") {
    const std::vector<Event> expected{
        {0.5, 1, 9}, {1.0, 0, 3}, {1.0, 0, 4}, {1.0, 1, 2}, {2.0, 0, 0}};
    ImpactQueue<Event> queue;
    for (std::size_t step : {1, 2, 3, 4}) {
        for (std::size_t k = 0; k < expected.size(); ++k)
            queue.push(expected[(k * step + 2) % expected.size()]);
        CHECK(drained(queue) == expected);
    }
}

TEST_CASE("impact queue: empty after it is cleared") {
    ImpactQueue<Event> queue;
    queue.push({1.0, 0, 0});
    queue.clear();
    CHECK(queue.is_empty());
}
