#include "lab/measure/pareto.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace carom;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("the Pareto front holds the choices that no other dominates") {
    struct Row {
        const char* what;
        std::vector<Tradeoff> choices;
        std::vector<bool> front;
    };
    const Row rows[] = {
        {"nothing", {}, {}},
        {"one alone", {{1, 1}}, {true}},
        {"a staircase and what is above it",
         {{3, 1}, {1, 3}, {2, 2}, {2, 3}, {3, 2}, {4, 4}},
         {true, true, true, false, false, false}},
        {"as cheap and better", {{1, 2}, {1, 1}}, {false, true}},
        {"as good and cheaper", {{2, 1}, {1, 1}}, {false, true}},
        {"duplicates: the first", {{1, 1}, {1, 1}, {2, 2}}, {true, false, false}},
        {"an error of zero", {{9, 0}, {1, 1e-300}}, {true, true}},
        {"the cheapest is lost", {{1, infinity}, {2, 5}}, {false, true}},
        {"no number", {{no_number, 1}, {1, no_number}, {3, 3}}, {false, false, true}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        CHECK(pareto_front(row.choices) == row.front);
    }
}

TEST_CASE("the most accurate within a budget, the cheapest within a tolerance") {
    const std::vector<Tradeoff> choices{{1, 8}, {2, 4}, {2, 4}, {3, 4}, {4, 1}, {9, infinity}};
    CHECK(best_within(choices, 0.5) == std::nullopt);
    CHECK(best_within(choices, 1) == 0);
    CHECK(best_within(choices, 3) == 1);
    CHECK(best_within(choices, 100) == 4);
    CHECK(cheapest_within(choices, 0.5) == std::nullopt);
    CHECK(cheapest_within(choices, 1) == 4);
    CHECK(cheapest_within(choices, 4) == 1);
    CHECK(cheapest_within(choices, infinity) == 0);
}
