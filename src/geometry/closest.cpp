#include "geometry/closest.h"

#include <algorithm>

namespace carom {

double closest_parameter(Vec2 start, Vec2 end, Vec2 point) {
    const Vec2 span = end - start;
    const double along = dot(point - start, span);
    if (!(along > 0.0)) return 0.0;
    const double whole = length_squared(span);
    return along >= whole ? 1.0 : along / whole;
}

Vec2 closest_point(Vec2 start, Vec2 end, Vec2 point) {
    const double t = closest_parameter(start, end, point);
    return t == 1.0 ? end : start + (end - start) * t;
}

double separation(const Disc& disc, const Disc& other) {
    return distance(disc.center, other.center) - (disc.radius + other.radius);
}

double separation(const Disc& disc, const Capsule& capsule) {
    return distance(disc.center, closest_point(capsule.start, capsule.end, disc.center)) -
           (disc.radius + capsule.radius);
}

bool is_inside(const Capsule& capsule, Vec2 point) {
    return length_squared(point - closest_point(capsule.start, capsule.end, point)) <=
           capsule.radius * capsule.radius;
}

Vec2 direction(Vec2 v, Vec2 otherwise) {
    const double size = length(v);
    if (size > 1e-150 && size < 1e150) return v / size;
    // Tiny or huge: scale to the larger coordinate first, so that the squares are representable.
    const double scale = std::max(std::fabs(v.x), std::fabs(v.y));
    if (!(scale > 0.0) || !std::isfinite(scale)) return otherwise;
    const Vec2 scaled = v / scale;
    return scaled / length(scaled);
}

}  // namespace carom
