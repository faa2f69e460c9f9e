#include "lab/measure/oracle_roots.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

// The roots of the oracle against polynomials made from the roots that they should have.
namespace carom {
namespace {

struct Plain {
    double value = 0.0;
    explicit Plain(double given) : value(given) {}
    friend Plain operator+(Plain a, Plain b) { return Plain(a.value + b.value); }
    friend Plain operator-(Plain a, Plain b) { return Plain(a.value - b.value); }
    friend Plain operator*(Plain a, Plain b) { return Plain(a.value * b.value); }
    friend Plain operator/(Plain a, Plain b) { return Plain(a.value / b.value); }
    friend bool operator<(Plain a, Plain b) { return a.value < b.value; }
    friend bool operator>(Plain a, Plain b) { return a.value > b.value; }
    friend int sign_of(Plain a) { return (a.value > 0.0) - (a.value < 0.0); }
};

using Polynomial = oracle::detail::Polynomial<Plain>;

Polynomial with_roots(double factor, const std::vector<double>& roots) {
    Polynomial result{Plain(factor)};
    for (const double root : roots) {
        Polynomial next(result.size() + 1, Plain(0.0));
        for (std::size_t i = 0; i < result.size(); ++i) {
            next[i + 1] = next[i + 1] + result[i];
            next[i] = next[i] - result[i] * Plain(root);
        }
        result = next;
    }
    return result;
}

TEST_CASE("all roots of a polynomial up to the end, ascending") {
    const std::vector<double> wanted{0.25, 0.5, 1.75, 3.0};
    for (const double factor : {1.0, -7.0}) {
        const auto found = oracle::detail::roots(with_roots(factor, wanted), Plain(4.0));
        REQUIRE(found.size() == wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            CHECK(found[i].value == doctest::Approx(wanted[i]).epsilon(1e-13));
        CHECK(oracle::detail::roots(with_roots(factor, wanted), Plain(1.0)).size() == 2);
    }
}

TEST_CASE("a root that touches zero is no sign change; a triple root is one") {
    CHECK(oracle::detail::roots(with_roots(1.0, {1.0, 1.0}), Plain(3.0)).empty());
    const auto triple = oracle::detail::roots(with_roots(1.0, {1.0, 1.0, 1.0}), Plain(3.0));
    REQUIRE(triple.size() == 1);
    CHECK(std::abs(triple[0].value - 1.0) < 1e-5);
}

TEST_CASE("the first fall from positive to negative") {
    Plain time(0.0);
    // Rises at 1, falls at 2.
    CHECK(oracle::detail::first_fall(with_roots(-1.0, {1.0, 2.0}), false, Plain(3.0), time));
    CHECK(time.value == doctest::Approx(2.0));
    CHECK_FALSE(oracle::detail::first_fall(with_roots(-1.0, {1.0, 2.0}), false, Plain(1.5), time));
    // Two bodies that touch at 0, part, and meet again at 2: the root at 0 does not count.
    CHECK(oracle::detail::first_fall(with_roots(-1.0, {0.0, 2.0}), true, Plain(3.0), time));
    CHECK(time.value == doctest::Approx(2.0));
    CHECK_FALSE(oracle::detail::first_fall(Polynomial{Plain(0.0)}, false, Plain(1.0), time));
}

}  // namespace
}  // namespace carom
