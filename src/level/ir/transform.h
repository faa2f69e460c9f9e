#pragma once

#include "geometry/elementary.h"
#include "geometry/vec2.h"

/// Where mirror, repeat and place put what they draw.
namespace carom {

/// Turns, flips and shifts; never stretches. (xx xy; yx yy) times a point, plus the shift. Exact
/// for flips and for turns by multiples of 90 degrees.
struct Transform {
    double xx = 1.0;
    double xy = 0.0;
    double yx = 0.0;
    double yy = 1.0;
    Vec2 shift;

    Vec2 direction(Vec2 v) const { return {xx * v.x + xy * v.y, yx * v.x + yy * v.y}; }
    Vec2 point(Vec2 p) const { return direction(p) + shift; }
    /// Left and right have changed places.
    bool reflects() const { return xx * yy - xy * yx < 0.0; }
    /// Boxes stay boxes.
    bool keeps_axes() const { return xx == 0.0 || xy == 0.0; }
};

/// First `inner`, then `outer`.
inline Transform after(const Transform& outer, const Transform& inner) {
    return {outer.xx * inner.xx + outer.xy * inner.yx, outer.xx * inner.xy + outer.xy * inner.yy,
            outer.yx * inner.xx + outer.yy * inner.yx, outer.yx * inner.xy + outer.yy * inner.yy,
            outer.point(inner.shift)};
}

inline Transform shift_by(Vec2 step) {
    return {1.0, 0.0, 0.0, 1.0, step};
}
/// Left and right exchanged about the vertical line at `x`.
inline Transform mirror_x(double x) {
    return {-1.0, 0.0, 0.0, 1.0, {2.0 * x, 0.0}};
}
/// Up and down exchanged about the horizontal line at `y`.
inline Transform mirror_y(double y) {
    return {1.0, 0.0, 0.0, -1.0, {0.0, 2.0 * y}};
}
/// Counter-clockwise about the origin.
inline Transform turn_by(double degrees) {
    const SinCos at = sin_cos_degrees(degrees);
    return {at.cos, -at.sin, at.sin, at.cos, {}};
}

}  // namespace carom
