#pragma once

#include <cstddef>
#include <vector>

/// Roots of polynomials, by bracketing them between the roots of their derivatives: the slow and
/// safe method of the oracle (oracle.h, which says what a Number has).
namespace carom::oracle {

template <typename Number>
struct Point {
    Number x;
    Number y;
};

namespace detail {

template <typename Number>
Point<Number> operator+(const Point<Number>& a, const Point<Number>& b) {
    return {Number(a.x + b.x), Number(a.y + b.y)};
}
template <typename Number>
Point<Number> operator-(const Point<Number>& a, const Point<Number>& b) {
    return {Number(a.x - b.x), Number(a.y - b.y)};
}
template <typename Number>
Point<Number> operator*(const Point<Number>& a, const Number& s) {
    return {Number(a.x * s), Number(a.y * s)};
}
template <typename Number>
Number dot(const Point<Number>& a, const Point<Number>& b) {
    return Number(a.x * b.x + a.y * b.y);
}

template <typename Number>
using Polynomial = std::vector<Number>;  // coefficients, the constant first

template <typename Number>
Number value(const Polynomial<Number>& p, const Number& t) {
    Number sum(0.0);
    for (std::size_t i = p.size(); i-- > 0;)
        sum = Number(sum * t + p[i]);
    return sum;
}

template <typename Number>
Polynomial<Number> derivative(const Polynomial<Number>& p) {
    Polynomial<Number> result;
    for (std::size_t i = 1; i < p.size(); ++i)
        result.push_back(Number(p[i] * Number(static_cast<double>(i))));
    return result;
}

// The root between two points of opposite sign: bisection, then Newton's method.
template <typename Number>
Number root_between(const Polynomial<Number>& p, Number low, Number high) {
    const int sign = sign_of(value(p, low));
    Number middle(0.0);
    for (int i = 0; i < 70; ++i) {
        middle = Number((low + high) * Number(0.5));
        if (sign_of(value(p, middle)) == sign)
            low = middle;
        else
            high = middle;
    }
    const Polynomial<Number> slope = derivative(p);
    Number root((low + high) * Number(0.5));
    for (int i = 0; i < 4; ++i) {
        const Number steep = value(slope, root);
        if (sign_of(steep) == 0) break;
        const Number next(root - value(p, root) / steep);
        if (next < low || next > high) break;
        root = next;
    }
    if (sign_of(value(slope, root)) != 0) return root;
    for (int i = 0; i < 260; ++i) {
        middle = Number((low + high) * Number(0.5));
        (sign_of(value(p, middle)) == sign ? low : high) = middle;
    }
    return low;
}

// All sign changes in 0..end, ascending.
template <typename Number>
std::vector<Number> roots(const Polynomial<Number>& p, const Number& end) {
    std::vector<Number> result;
    if (p.size() < 2) return result;
    std::vector<Number> places = roots(derivative(p), end);
    places.insert(places.begin(), Number(0.0));
    places.push_back(end);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const int before = sign_of(value(p, places[i]));
        const int after = sign_of(value(p, places[i + 1]));
        if (before != 0 && after != 0 && before != after)
            result.push_back(root_between(p, places[i], places[i + 1]));
    }
    return result;
}

// The first time after 0, up to `end`, at which p changes from positive to negative. A contact has
// p = 0 at 0, and that root does not count.
template <typename Number>
bool first_fall(Polynomial<Number> p, bool is_touching, const Number& end, Number& time) {
    if (is_touching) p.erase(p.begin());
    while (!p.empty() && sign_of(p.back()) == 0)
        p.pop_back();
    if (p.empty() || sign_of(end) <= 0) return false;
    int sign = sign_of(p[0]);
    for (const Number& root : roots(p, end)) {
        if (sign > 0) {
            time = root;
            return true;
        }
        sign = -sign;
    }
    return false;
}

// Whether c + b t + a t^2 clearly stays positive for t > 0, judged generously.
inline bool passes_by(double c, double b, double a) {
    if (!(c > 0.0)) return false;
    return b >= 0.0 || b * b - 4.0 * a * c < -1e-9 * (b * b + 4.0 * a * c);
}

}  // namespace detail

}  // namespace carom::oracle
