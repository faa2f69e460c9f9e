#pragma once

#include <cmath>

/// Vectors of the plane. x points right, y points up.
///
/// All operations use + - * / and sqrt only, which IEEE 754 defines exactly, so results have the
/// same bits on every machine.
namespace carom {

/// A point or a free vector. Units: those of the quantity it holds (length, length/s, ...).
struct Vec2 {
    double x = 0.0;
    double y = 0.0;

    friend constexpr bool operator==(Vec2, Vec2) = default;
    constexpr Vec2& operator+=(Vec2 b) {
        x += b.x;
        y += b.y;
        return *this;
    }
    constexpr Vec2& operator-=(Vec2 b) {
        x -= b.x;
        y -= b.y;
        return *this;
    }
    constexpr Vec2& operator*=(double s) {
        x *= s;
        y *= s;
        return *this;
    }
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) {
    return {a.x + b.x, a.y + b.y};
}
constexpr Vec2 operator-(Vec2 a, Vec2 b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Vec2 operator-(Vec2 a) {
    return {-a.x, -a.y};
}
constexpr Vec2 operator*(Vec2 a, double s) {
    return {a.x * s, a.y * s};
}
constexpr Vec2 operator*(double s, Vec2 a) {
    return {a.x * s, a.y * s};
}
constexpr Vec2 operator/(Vec2 a, double s) {
    return {a.x / s, a.y / s};
}

constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}

/// The z component of the cross product: positive when `b` points to the left of `a`.
constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// `a` rotated by 90 degrees counter-clockwise.
constexpr Vec2 perpendicular(Vec2 a) {
    return {-a.y, a.x};
}

constexpr double length_squared(Vec2 a) {
    return dot(a, a);
}

/// Overflows to infinity beyond about 1e154, underflows to 0 below about 1e-154.
inline double length(Vec2 a) {
    return std::sqrt(dot(a, a));
}

inline double distance(Vec2 a, Vec2 b) {
    return length(a - b);
}

}  // namespace carom
