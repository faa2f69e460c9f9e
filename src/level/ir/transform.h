#pragma once

#include "geometry/elementary.h"
#include "geometry/vec2.h"

/// The rigid motions of mirror, repeat and place.
namespace carom {

/// A rotation or reflection, then a translation: p -> (xx xy; yx yy) p + shift. Exact for
/// reflections and for rotations by multiples of 90 degrees.
struct Transform {
    double xx = 1.0;
    double xy = 0.0;
    double yx = 0.0;
    double yy = 1.0;
    Vec2 shift;

    Vec2 direction(Vec2 v) const { return {xx * v.x + xy * v.y, yx * v.x + yy * v.y}; }
    Vec2 point(Vec2 p) const { return direction(p) + shift; }
    /// Whether it exchanges left and right.
    bool reflects() const { return xx * yy - xy * yx < 0.0; }
    /// Whether axis-parallel boxes stay axis-parallel.
    bool keeps_axes() const { return xx == 0.0 || xy == 0.0; }
};

/// The composition: first `inner`, then `outer`.
inline Transform after(const Transform& outer, const Transform& inner) {
    return {outer.xx * inner.xx + outer.xy * inner.yx, outer.xx * inner.xy + outer.xy * inner.yy,
            outer.yx * inner.xx + outer.yy * inner.yx, outer.yx * inner.xy + outer.yy * inner.yy,
            outer.point(inner.shift)};
}

inline Transform shift_by(Vec2 step) {
    return {1.0, 0.0, 0.0, 1.0, step};
}
/// The reflection in the vertical line at `x`.
inline Transform mirror_x(double x) {
    return {-1.0, 0.0, 0.0, 1.0, {2.0 * x, 0.0}};
}
/// The reflection in the horizontal line at `y`.
inline Transform mirror_y(double y) {
    return {1.0, 0.0, 0.0, -1.0, {0.0, 2.0 * y}};
}
/// The counter-clockwise rotation about the origin.
inline Transform turn_by(double degrees) {
    const SinCos at = sin_cos_degrees(degrees);
    return {at.cos, -at.sin, at.sin, at.cos, {}};
}

}  // namespace carom
