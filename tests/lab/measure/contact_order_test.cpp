#include "lab/measure/contact_order.h"

#include <doctest/doctest.h>

#include <vector>

using namespace carom;

namespace {

using Meetings = std::vector<Meeting>;

Meeting balls(double time, std::uint32_t a, std::uint32_t b) {
    return {time, ContactKind::ball_ball, a, b};
}
Meeting edge(double time, std::uint32_t ball, std::uint32_t edge) {
    return {time, ContactKind::ball_edge, ball, edge};
}

}  // namespace

TEST_CASE("contacts missed, extra and out of order") {
    struct Row {
        const char* what;
        Meetings truth;
        Meetings given;
        OrderFaults faults;
    };
    const Row rows[] = {
        {"nothing", {}, {}, {0, 0, 0}},
        {"the same", {balls(1, 0, 1), edge(2, 0, 0)}, {balls(1.1, 0, 1), edge(2, 0, 0)}, {0, 0, 0}},
        {"one missed", {balls(1, 0, 1), balls(2, 0, 1)}, {balls(1, 0, 1)}, {1, 0, 0}},
        {"all missed", {balls(1, 0, 1)}, {}, {1, 0, 0}},
        {"one too many", {balls(1, 0, 1)}, {balls(1, 0, 1), edge(2, 0, 1)}, {0, 1, 0}},
        {"an edge is no ball", {balls(1, 0, 1)}, {edge(1, 0, 1)}, {1, 1, 0}},
        {"two of one ball swapped",
         {balls(1, 0, 1), edge(2, 0, 5)},
         {edge(1, 0, 5), balls(2, 0, 1)},
         {0, 0, 1}},
        {"two of different balls swapped",
         {balls(1, 0, 1), balls(2, 2, 3)},
         {balls(1, 2, 3), balls(2, 0, 1)},
         {0, 0, 0}},
        {"the last comes first",
         {edge(1, 0, 1), edge(2, 0, 2), edge(3, 0, 3), edge(4, 0, 4)},
         {edge(1, 0, 4), edge(2, 0, 1), edge(3, 0, 2), edge(4, 0, 3)},
         {0, 0, 1}},
        {"turned round",
         {edge(1, 0, 1), edge(2, 0, 2), edge(3, 0, 3)},
         {edge(1, 0, 3), edge(2, 0, 2), edge(3, 0, 1)},
         {0, 0, 2}},
        {"a contact out of order for both of its balls counts once",
         {balls(1, 0, 1), edge(2, 0, 7), edge(3, 0, 9), edge(2, 1, 8), edge(3, 1, 9)},
         {edge(1, 0, 7), edge(1, 0, 9), edge(1, 1, 8), edge(1, 1, 9), balls(2, 0, 1)},
         {0, 0, 1}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const OrderFaults faults = order_faults(row.truth, row.given);
        CHECK(faults.missed == row.faults.missed);
        CHECK(faults.extra == row.faults.extra);
        CHECK(faults.out_of_order == row.faults.out_of_order);
    }
}

TEST_CASE("the first difference is the earliest one within the contacts of a ball") {
    const Meetings first{balls(1, 0, 1), edge(2, 2, 0), edge(3, 0, 4), edge(4, 1, 4)};
    const Meetings second{edge(0.9, 2, 0), balls(1, 0, 1), edge(3.5, 0, 5), edge(4, 1, 3)};
    const auto found = first_difference(first, second, 10);
    REQUIRE(found.has_value());
    CHECK(found->ball == 0);
    CHECK(found->time == 3);
    REQUIRE(found->first.has_value());
    CHECK(found->first->b == 4);
    REQUIRE(found->second.has_value());
    CHECK(found->second->b == 5);
    CHECK_FALSE(first_difference(first, first, 10).has_value());
}

TEST_CASE("consecutive repeats count as one contact for the first difference") {
    const Meetings bounces{edge(1, 0, 0), edge(2, 0, 0), edge(3, 0, 0), edge(4, 0, 1)};
    const Meetings rests{edge(1, 0, 0), edge(4.1, 0, 1), edge(4.2, 0, 1)};
    CHECK_FALSE(first_difference(bounces, rests, 10).has_value());
}

TEST_CASE("a contact of one run only is a difference, unless the other run had no time for it") {
    const Meetings one{balls(1, 0, 1), edge(5, 1, 2)};
    const Meetings other{balls(1, 0, 1)};
    const auto found = first_difference(one, other, 9);
    REQUIRE(found.has_value());
    CHECK(found->ball == 1);
    CHECK(found->time == 5);
    CHECK(found->first.has_value());
    CHECK_FALSE(found->second.has_value());
    CHECK_FALSE(first_difference(one, other, 5).has_value());
}
