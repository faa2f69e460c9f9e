#include "geometry/double_double.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <doctest/doctest.h>

using namespace carom;

namespace {

// A small generator, since the tests of geometry use nothing above geometry.
class Draws {
  public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}
    // Uniform in [low, high).
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    }
    // Random sign, log-uniform magnitude.
    double sized(int low, int high) {
        const double value = std::ldexp(between(1.0, 2.0), static_cast<int>(between(low, high)));
        return bits() % 2 == 0 ? value : -value;
    }
    DoubleDouble wide(int low, int high) {
        const double value = sized(low, high);
        return exact_sum_of_ordered(value, value * 0x1p-54 * between(-1.0, 1.0));
    }

  private:
    std::uint64_t bits() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return state_ * 0x2545f4914f6cdd1dULL;
    }
    std::uint64_t state_;
};

// 128-bit integers, an extension of both compilers.
__extension__ using Whole = unsigned __int128;
__extension__ using SignedWhole = __int128;

constexpr int rounds = 20'000;
constexpr double unit = 0x1p-102;  // the error stated in the header

bool is_normal(const DoubleDouble& a) {
    return a.high == a.high + a.low;
}
// Whether both agree within `units` of rounding, relative to `scale`.
bool are_near(const DoubleDouble& a, const DoubleDouble& b, double units, double scale) {
    return std::fabs((a - b).high) <= units * unit * std::fabs(scale);
}

}  // namespace

TEST_CASE("double-double: the sum of two doubles and its error are exact") {
    Draws draws(1);
    for (int i = 0; i < rounds; ++i) {
        const double a = draws.sized(-40, 40);
        const double b = draws.sized(-40, 40);
        const DoubleDouble sum = exact_sum(a, b);
        CHECK(sum.high == a + b);
        CHECK(is_normal(sum));
        // Subtracting the summands leaves nothing: all intermediate results are exact.
        CHECK(sum - DoubleDouble(a) == DoubleDouble(b));
        CHECK(sum - DoubleDouble(b) == DoubleDouble(a));
        CHECK(sum == exact_sum(b, a));
        if (std::fabs(a) >= std::fabs(b)) CHECK(exact_sum_of_ordered(a, b) == sum);
    }
}

TEST_CASE("double-double: the product of two doubles and its error are exact") {
    Draws draws(2);
    for (int i = 0; i < rounds; ++i) {
        // Numbers of 26 bits have exact products, so the products of the parts are known.
        const double a = std::floor(draws.between(0x1p51, 0x1p52)) + 0x1p52;
        const double b = std::floor(draws.between(0x1p51, 0x1p52)) + 0x1p52;
        const auto whole = static_cast<Whole>(a) * static_cast<Whole>(b);
        const DoubleDouble product = exact_product(a, b);
        CHECK(product.high == a * b);
        const auto back =
            static_cast<SignedWhole>(product.high) + static_cast<SignedWhole>(product.low);
        CHECK(static_cast<Whole>(back) == whole);
        // Scaling by a power of two is exact.
        CHECK(exact_product(a * 0x1p-400, b * 0x1p300).low == product.low * 0x1p-100);
    }
}

TEST_CASE("double-double: identities hold to 102 bits") {
    Draws draws(3);
    for (int i = 0; i < rounds; ++i) {
        const DoubleDouble a = draws.wide(-30, 30);
        const DoubleDouble b = draws.wide(-30, 30);
        const DoubleDouble c = draws.wide(-30, 30);
        const double size = std::max(std::fabs(a.high), std::fabs(b.high));
        CHECK(is_normal(a + b));
        CHECK(is_normal(a * b));
        CHECK(is_normal(a / b));
        CHECK(a + b == b + a);
        CHECK(a * b == b * a);
        CHECK(a - a == DoubleDouble());
        CHECK(are_near((a + b) - a, b, 2, size));
        CHECK(are_near(a * b / b, a, 3, a.high));
        CHECK(are_near(a / b * b, a, 3, a.high));
        CHECK(are_near(a * (b + c), a * b + a * c, 6,
                       a.high * (std::fabs(b.high) + std::fabs(c.high))));
        CHECK(are_near((a + b) * (a - b), a * a - b * b, 8, size * size));
        CHECK(a / a == DoubleDouble(1.0));
        const DoubleDouble positive = absolute(a);
        CHECK(positive.high > 0.0);
        const DoubleDouble root = square_root(positive);
        CHECK(is_normal(root));
        CHECK(are_near(root * root, positive, 3, positive.high));
        CHECK(are_near(square_root(positive * positive), positive, 3, positive.high));
    }
}

TEST_CASE("double-double: exact where the result is a double") {
    Draws draws(4);
    for (int i = 0; i < rounds; ++i) {
        const double a = std::floor(draws.between(1.0, 0x1p26));
        const double b = std::floor(draws.between(1.0, 0x1p26));
        CHECK(DoubleDouble(a) * DoubleDouble(b) == DoubleDouble(a * b));
        CHECK(DoubleDouble(a * b) / DoubleDouble(b) == DoubleDouble(a));
        CHECK(are_near(square_root(DoubleDouble(a * a)), DoubleDouble(a), 1, a));
    }
    CHECK(square_root(DoubleDouble()) == DoubleDouble());
    CHECK(square_root(2.25) == 1.5);
}

TEST_CASE("double-double: ordered by the value of the sum") {
    Draws draws(5);
    for (int i = 0; i < rounds; ++i) {
        const DoubleDouble a = draws.wide(-3, 3);
        const DoubleDouble near =
            a + DoubleDouble(std::ldexp(a.high, -80) * draws.between(-1.0, 1.0));
        const double difference = (near - a).high;
        CHECK((near > a) == (difference > 0.0));
        CHECK((near < a) == (difference < 0.0));
        CHECK((near >= a) == (difference >= 0.0));
        CHECK((near <= a) == (difference <= 0.0));
        CHECK(absolute(-a) == absolute(a));
    }
    CHECK(absolute(DoubleDouble(0.0, -1e-30)) == DoubleDouble(0.0, 1e-30));
}

TEST_CASE("double-double: the root of two has 31 correct digits") {
    // sqrt(2) = 1.41421356237309504880168872420969807856967...; the nearest double, and the
    // remainder, which is known to 16 digits.
    const DoubleDouble root = square_root(DoubleDouble(2.0));
    CHECK(root.high == 1.4142135623730951);
    CHECK(root.low == doctest::Approx(-9.667293313452913e-17).epsilon(1e-14));
    // A third of one, times three.
    const DoubleDouble third = DoubleDouble(1.0) / DoubleDouble(3.0);
    CHECK(std::fabs((third * DoubleDouble(3.0) - DoubleDouble(1.0)).high) <= unit);
}
