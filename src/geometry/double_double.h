#pragma once

#include <cmath>

/// A number of about 32 digits: the sum of two doubles, of which `low` is at most half a unit in
/// the last place of `high`. With it, a test compares the solver `event` with itself at twice the
/// precision, with the same bits on every machine.
///
/// Uses + - * / and sqrt only, no fused multiply-add. Relative error of each operation: at most
/// 2^-102 (about 2e-31), for magnitudes between 1e-140 and 1e140. Infinities and NaN stay so in
/// `high`; `low` then means nothing.
/// Sources: Dekker, A floating-point technique for extending the available precision (1971); Knuth,
/// The Art of Computer Programming, vol. 2, 4.2.2; Karp and Markstein (1997) for the root.
namespace carom {

struct DoubleDouble {
    double high = 0.0;
    double low = 0.0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double value)
        : high(value) {}  // implicit: every double is a DoubleDouble
    constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
    constexpr explicit operator double() const { return high; }

    friend constexpr bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
    friend constexpr bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
    friend constexpr bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    friend constexpr bool operator<=(const DoubleDouble& a, const DoubleDouble& b) {
        return a.high < b.high || (a.high == b.high && a.low <= b.low);
    }
    friend constexpr bool operator>=(const DoubleDouble& a, const DoubleDouble& b) {
        return b <= a;
    }
    friend constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
};

/// a + b exactly, as the rounded sum and its error.
constexpr DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

/// a + b exactly, for |a| >= |b|: cheaper than exact_sum.
constexpr DoubleDouble exact_sum_of_ordered(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a * b exactly, as the rounded product and its error. Pre: magnitudes below 1e290.
constexpr DoubleDouble exact_product(double a, double b) {
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

constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = exact_sum(a.high, b.high);
    const DoubleDouble low = exact_sum(a.low, b.low);
    const DoubleDouble sum = exact_sum_of_ordered(high.high, high.low + low.high);
    return exact_sum_of_ordered(sum.high, sum.low + low.low);
}
constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + -b;
}
constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return exact_sum_of_ordered(product.high, product.low + (a.high * b.low + a.low * b.high));
}
constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high / b.high;
    const DoubleDouble rest_of_rest = rest - b * DoubleDouble(second);
    const DoubleDouble sum = exact_sum_of_ordered(first, second);
    return sum + DoubleDouble(rest_of_rest.high / b.high);
}
constexpr DoubleDouble& operator+=(DoubleDouble& a, const DoubleDouble& b) {
    return a = a + b;
}
constexpr DoubleDouble& operator-=(DoubleDouble& a, const DoubleDouble& b) {
    return a = a - b;
}
constexpr DoubleDouble& operator*=(DoubleDouble& a, const DoubleDouble& b) {
    return a = a * b;
}

/// Pre: a >= 0.
inline DoubleDouble square_root(const DoubleDouble& a) {
    if (a.high == 0.0) return {};
    const double inverse = 1.0 / std::sqrt(a.high);
    const double root = a.high * inverse;
    const DoubleDouble rest = a - exact_product(root, root);
    const DoubleDouble once = exact_sum(root, rest.high * (inverse * 0.5));
    const DoubleDouble rest_of_rest = a - once * once;
    return once + DoubleDouble(rest_of_rest.high * (inverse * 0.5));
}
inline double square_root(double a) {
    return std::sqrt(a);
}

constexpr DoubleDouble absolute(const DoubleDouble& a) {
    return a.high < 0.0 || (a.high == 0.0 && a.low < 0.0) ? -a : a;
}
inline double absolute(double a) {
    return std::fabs(a);
}

/// The distance from 1 to the next number, for code that works with both number types.
template <typename Real>
inline constexpr double precision = 0.0;
template <>
inline constexpr double precision<double> = 2.220446049250313e-16;
template <>
inline constexpr double precision<DoubleDouble> = 4.930380657631324e-32;  // 2^-104

}  // namespace carom
