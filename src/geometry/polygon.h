#pragma once

#include <cstddef>
#include <span>

namespace carom {

/// Whether `point` lies in the polygon, by the even-odd rule. On its boundary either may come out;
/// a polygon with fewer than three corners holds nothing. `Point` has the coordinates x and y.
template <typename Point>
bool is_inside_polygon(std::span<const Point> corners, Point point) {
    bool is_inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Point a = corners[i];
        const Point b = corners[j];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) is_inside = !is_inside;
    }
    return is_inside;
}

}  // namespace carom
