#pragma once

#include <algorithm>

#include "geometry/vec2.h"

/// The shapes: discs for balls, capsules for edges and zones, and boxes that bound them.
namespace carom {

/// Invariant: radius >= 0. Units: length.
struct Disc {
    Vec2 center;
    double radius = 0.0;

    friend constexpr bool operator==(const Disc&, const Disc&) = default;
};

/// All points within `radius` of the segment from `start` to `end`.
/// start == end makes it a disc (a peg); radius == 0 makes it a line. Units: length.
struct Capsule {
    Vec2 start;
    Vec2 end;
    double radius = 0.0;

    friend constexpr bool operator==(const Capsule&, const Capsule&) = default;
};

/// An axis-parallel box. Invariant: low <= high in both coordinates. Units: length.
struct Box {
    Vec2 low;
    Vec2 high;

    friend constexpr bool operator==(const Box&, const Box&) = default;
};

constexpr Vec2 size(const Box& box) {
    return box.high - box.low;
}
constexpr Vec2 center(const Box& box) {
    return (box.low + box.high) * 0.5;
}

/// The smallest box that contains both.
constexpr Box join(const Box& a, const Box& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// The box extended by `margin` on each side; a negative margin shrinks it.
constexpr Box grow(const Box& box, double margin) {
    return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

constexpr Box bounds(const Disc& disc) {
    return grow({disc.center, disc.center}, disc.radius);
}

constexpr Box bounds(const Capsule& c) {
    return grow(join({c.start, c.start}, {c.end, c.end}), c.radius);
}

/// Whether two boxes overlap; boxes that only touch do.
constexpr bool overlaps(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Whether the point is in the box or on its boundary.
constexpr bool contains(const Box& box, Vec2 point) {
    return box.low.x <= point.x && point.x <= box.high.x && box.low.y <= point.y &&
           point.y <= box.high.y;
}

}  // namespace carom
