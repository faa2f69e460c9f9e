#pragma once

#include "geometry/shapes.h"

/// Closest points, and what is inside what.
namespace carom {

/// Where on the segment start..end the point nearest `point` lies: 0 at the start, 1 at the end. 0
/// for a segment without length.
double closest_parameter(Vec2 start, Vec2 end, Vec2 point);

/// The point of the segment nearest `point`.
Vec2 closest_point(Vec2 start, Vec2 end, Vec2 point);

/// How far `disc` and `other` are apart, a length; negative is the depth of the overlap.
double separation(const Disc& disc, const Disc& other);
double separation(const Disc& disc, const Capsule& capsule);

/// Whether `point` lies in the capsule or on its rim.
bool is_inside(const Capsule& capsule, Vec2 point);

/// The unit vector along `v`; `otherwise` when v has no length (or one that under- or overflows).
Vec2 direction(Vec2 v, Vec2 otherwise);

}  // namespace carom
