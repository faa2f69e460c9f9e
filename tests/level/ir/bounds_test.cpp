#include "level/ir/bounds.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("bounds: what a remedy proposes is allowed, and what is allowed needs no remedy") {
    using enum Bound;
    for (const Bound bound : {any, not_negative, positive, unit_interval, positive_unit_interval,
                              up_to_thousand, layer}) {
        CAPTURE(demand(bound));
        for (const double number : {-250.0, -2.0, -0.5, 0.0, 0.5, 1.0, 2.0, 50.0, 250.0, 5000.0}) {
            CAPTURE(number);
            if (holds(number, bound) || bound == layer) continue;
            CHECK_FALSE(demand(bound).empty());
            if (const auto allowed = nearest_allowed(number, bound)) CHECK(holds(*allowed, bound));
        }
    }
    CHECK(holds(0.0, not_negative));
    CHECK_FALSE(holds(0.0, positive));
    CHECK(holds(0.0, unit_interval));
    CHECK_FALSE(holds(0.0, positive_unit_interval));
    CHECK_FALSE(holds(1001.0, up_to_thousand));
    CHECK_FALSE(holds(4.0, layer));
    CHECK(holds(-1e9, any));
    CHECK(nearest_allowed(-0.2, positive) == 0.2);
    // Percent in place of a share.
    CHECK(nearest_allowed(50.0, unit_interval) == 0.5);
}
