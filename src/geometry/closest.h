#pragma once

#include "geometry/shapes.h"

/// Closest points, distances and containment.
namespace carom {

/// The parameter, 0 at `start` to 1 at `end`, of the point of the segment nearest `point`. 0 for a
/// segment of length zero.
inline double closest_parameter(Vec2 start, Vec2 end, Vec2 point) {
    const Vec2 span = end - start;
    const double along = dot(point - start, span);
    if (!(along > 0.0)) return 0.0;
    const double whole = length_squared(span);
    return along >= whole ? 1.0 : along / whole;
}

/// The point of the segment that is nearest `point`.
inline Vec2 closest_point(Vec2 start, Vec2 end, Vec2 point) {
    const double t = closest_parameter(start, end, point);
    return t == 1.0 ? end : start + (end - start) * t;
}

/// The distance between the surfaces of two bodies, a length; negative where they overlap, by the
/// depth of the overlap.
double separation(const Disc& disc, const Disc& other);
double separation(const Disc& disc, const Capsule& capsule);

/// Whether `point` lies in the capsule or on its boundary.
bool is_inside(const Capsule& capsule, Vec2 point);

/// The slow path of direction(): scales the vector first, so that tiny and huge vectors work too.
Vec2 direction_by_scale(Vec2 v, Vec2 otherwise);

/// The unit vector along `v`; `otherwise` if v is zero or not finite.
inline Vec2 direction(Vec2 v, Vec2 otherwise) {
    const double size = length(v);
    return size > 1e-150 && size < 1e150 ? v / size : direction_by_scale(v, otherwise);
}

}  // namespace carom
