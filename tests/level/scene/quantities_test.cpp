#include "level/scene/quantities.h"

#include <doctest/doctest.h>

#include <set>

using namespace carom;

TEST_CASE("quantities have unique names and fields, and the function of their scope") {
    std::set<std::string_view> names;
    std::set<std::string_view> keys;
    for (const QuantityRow& row : quantities()) {
        CAPTURE(row.name);
        // "pressure" and "pressure(wall)" share a name.
        if (row.scope != QuantityScope::edges) CHECK(names.insert(row.name).second);
        CHECK((row.scope == QuantityScope::world) == (row.of_world != nullptr));
        CHECK((row.scope == QuantityScope::ball) == (row.of_ball != nullptr));
        if (row.scope != QuantityScope::run) CHECK_FALSE((row.at_tick != nullptr));
        if (!row.field.key.empty()) CHECK(keys.insert(row.field.key).second);
    }
    CHECK(quantity_in("pressure")->scope == QuantityScope::run);
    CHECK(quantity_in("pressure(wall)")->scope == QuantityScope::edges);
    CHECK(quantity_in("mean(bins)") == quantity_named("mean"));
    CHECK(name(quantity_named("chi_square")) == "chi_square");
    CHECK(name(quantity_named("x")) == "x");
    CHECK(name(quantity_named("removed")) == "removed");
    CHECK_FALSE(is_of_ball(quantity_named("removed")));
    CHECK(is_of_ball(quantity_named("speed")));
    CHECK_FALSE(is_of_bins(quantity_named("speed")));
    CHECK(is_of_bins(quantity_named("count")));
}

TEST_CASE("binomial shares sum to 1 and have the right mean") {
    CHECK(binomial_shares(2, 0.5) == std::vector<double>{0.25, 0.5, 0.25});
    CHECK(binomial_shares(0, 0.5) == std::vector<double>{1.0});
    CHECK(binomial_shares(3, 0.0) == std::vector<double>{1, 0, 0, 0});
    CHECK(binomial_shares(3, 1.0) == std::vector<double>{0, 0, 0, 1});
    const auto shares = binomial_shares(5000, 0.3);
    double sum = 0.0;
    double mean = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        sum += shares[k];
        mean += static_cast<double>(k) * shares[k];
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    CHECK(mean == doctest::Approx(1500).epsilon(1e-12));
}
