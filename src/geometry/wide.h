#pragma once

#include <cmath>

/// A number of about 32 digits: the sum of two doubles, of which `low` is at most half a unit in
/// the last place of `high`. It exists so that the solver `event` can be run against itself at
/// twice the precision, with the same bits on every machine.
///
/// Only + - * / and sqrt, without fused multiply-add. Relative error of each: at most 2^-102 (about
/// 2e-31), for values whose size is between 1e-140 and 1e140. Infinities and what is not a number
/// stay so in `high`; `low` then means nothing.
/// Sources: Dekker, A floating-point technique for extending the available precision (1971); Knuth,
/// The Art of Computer Programming, vol. 2, 4.2.2; Karp and Markstein (1997) for the root.
namespace carom {

struct Wide {
    double high = 0.0;
    double low = 0.0;

    constexpr Wide() = default;
    constexpr Wide(double value) : high(value) {}  // a double is a Wide: meant to be implicit
    constexpr Wide(double h, double l) : high(h), low(l) {}
    constexpr explicit operator double() const { return high; }

    friend constexpr bool operator==(const Wide&, const Wide&) = default;
    friend constexpr bool operator<(const Wide& a, const Wide& b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
    friend constexpr bool operator>(const Wide& a, const Wide& b) { return b < a; }
    friend constexpr bool operator<=(const Wide& a, const Wide& b) {
        return a.high < b.high || (a.high == b.high && a.low <= b.low);
    }
    friend constexpr bool operator>=(const Wide& a, const Wide& b) { return b <= a; }
    friend constexpr Wide operator-(const Wide& a) { return {-a.high, -a.low}; }
};

/// a + b exactly, as the rounded sum and its error.
constexpr Wide exact_sum(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

/// The same where |a| >= |b|.
constexpr Wide exact_sum_of_ordered(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a * b exactly, as the rounded product and its error. Pre: sizes below 1e290.
constexpr Wide exact_product(double a, double b) {
    constexpr double splitter = 134217729.0;  // 2^27 + 1
    const double product = a * b;
    const double big_a = splitter * a;
    const double a_high = big_a - (big_a - a);
    const double a_low = a - a_high;
    const double big_b = splitter * b;
    const double b_high = big_b - (big_b - b);
    const double b_low = b - b_high;
    return {product,
            ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

constexpr Wide operator+(const Wide& a, const Wide& b) {
    const Wide high = exact_sum(a.high, b.high);
    const Wide low = exact_sum(a.low, b.low);
    const Wide sum = exact_sum_of_ordered(high.high, high.low + low.high);
    return exact_sum_of_ordered(sum.high, sum.low + low.low);
}
constexpr Wide operator-(const Wide& a, const Wide& b) {
    return a + -b;
}
constexpr Wide operator*(const Wide& a, const Wide& b) {
    const Wide product = exact_product(a.high, b.high);
    return exact_sum_of_ordered(product.high, product.low + (a.high * b.low + a.low * b.high));
}
constexpr Wide operator/(const Wide& a, const Wide& b) {
    const double first = a.high / b.high;
    const Wide rest = a - b * Wide(first);
    const double second = rest.high / b.high;
    const Wide rest_of_rest = rest - b * Wide(second);
    const Wide sum = exact_sum_of_ordered(first, second);
    return sum + Wide(rest_of_rest.high / b.high);
}
constexpr Wide& operator+=(Wide& a, const Wide& b) {
    return a = a + b;
}
constexpr Wide& operator-=(Wide& a, const Wide& b) {
    return a = a - b;
}
constexpr Wide& operator*=(Wide& a, const Wide& b) {
    return a = a * b;
}

/// Pre: a >= 0.
inline Wide square_root(const Wide& a) {
    if (a.high == 0.0) return {};
    const double inverse = 1.0 / std::sqrt(a.high);
    const double root = a.high * inverse;
    const Wide rest = a - exact_product(root, root);
    const Wide once = exact_sum(root, rest.high * (inverse * 0.5));
    const Wide rest_of_rest = a - once * once;
    return once + Wide(rest_of_rest.high * (inverse * 0.5));
}
inline double square_root(double a) {
    return std::sqrt(a);
}

constexpr Wide absolute(const Wide& a) {
    return a.high < 0.0 || (a.high == 0.0 && a.low < 0.0) ? -a : a;
}
inline double absolute(double a) {
    return std::fabs(a);
}

/// The distance from 1 to the next number, as far as code that works with both must know it.
template <typename Real>
inline constexpr double precision = 0.0;
template <>
inline constexpr double precision<double> = 2.220446049250313e-16;
template <>
inline constexpr double precision<Wide> = 4.930380657631324e-32;  // 2^-104

}  // namespace carom
