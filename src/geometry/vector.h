#pragma once

#include "geometry/double_double.h"
#include "geometry/vec2.h"

/// A Vec2 over any number type, with the operations of vec2.h. The solver `event` uses it, so that
/// one source runs in doubles and in higher precision.
namespace carom {

template <typename Real>
struct Vector {
    Real x{};
    Real y{};

    constexpr Vector() = default;
    constexpr Vector(Real vx, Real vy) : x(vx), y(vy) {}
    constexpr explicit Vector(Vec2 v) : x(v.x), y(v.y) {}
    constexpr explicit operator Vec2() const {
        return {static_cast<double>(x), static_cast<double>(y)};
    }

    friend constexpr bool operator==(const Vector&, const Vector&) = default;
    friend constexpr Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y};
    }
    friend constexpr Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y};
    }
    friend constexpr Vector operator-(const Vector& a) { return {-a.x, -a.y}; }
    friend constexpr Vector operator*(const Vector& a, const Real& s) { return {a.x * s, a.y * s}; }
    friend constexpr Vector operator*(const Real& s, const Vector& a) { return a * s; }
    friend constexpr Vector operator/(const Vector& a, const Real& s) { return {a.x / s, a.y / s}; }
    constexpr Vector& operator+=(const Vector& b) { return *this = *this + b; }
    constexpr Vector& operator-=(const Vector& b) { return *this = *this - b; }
};

template <typename Real>
constexpr Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return a.x * b.x + a.y * b.y;
}
template <typename Real>
constexpr Real cross(const Vector<Real>& a, const Vector<Real>& b) {
    return a.x * b.y - a.y * b.x;
}
template <typename Real>
constexpr Vector<Real> perpendicular(const Vector<Real>& a) {
    return {-a.y, a.x};
}
template <typename Real>
constexpr Real length_squared(const Vector<Real>& a) {
    return dot(a, a);
}
template <typename Real>
Real length(const Vector<Real>& a) {
    return square_root(dot(a, a));
}

}  // namespace carom
