#include "geometry/closest.h"

#include <algorithm>

namespace carom {

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

// Scaling by the larger coordinate keeps the squares from over- and underflowing.
Vec2 direction_by_scale(Vec2 v, Vec2 otherwise) {
    const double scale = std::max(std::fabs(v.x), std::fabs(v.y));
    if (!(scale > 0.0) || !std::isfinite(scale)) return otherwise;
    const Vec2 scaled = v / scale;
    return scaled / length(scaled);
}

}  // namespace carom
