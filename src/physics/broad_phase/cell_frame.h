#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/world.h"

/// The plane cut into equal cells, so that only neighbours are compared.
///
/// What lies outside the frame belongs to the cells of its border, so a frame of any size gives the
/// same pairs; it should hold most balls for speed. On a torus the frame is the torus, and cells
/// wrap around.
namespace carom {

struct CellFrame {
    Vec2 origin;
    Vec2 cell{1.0, 1.0};  ///< width and height of a cell, length, > 0
    int columns = 1;
    int rows = 1;
    bool wraps = false;

    friend bool operator==(const CellFrame&, const CellFrame&) = default;

    int column_unbounded(double x) const { return whole((x - origin.x) / cell.x); }
    int row_unbounded(double y) const { return whole((y - origin.y) / cell.y); }
    [[gnu::always_inline]] int column(double x) const {
        return bounded(column_unbounded(x), columns);
    }
    [[gnu::always_inline]] int row(double y) const { return bounded(row_unbounded(y), rows); }
    std::uint32_t index(int column, int row) const {
        return static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(columns) +
               static_cast<std::uint32_t>(column);
    }
    std::size_t count() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    /// A cell number brought into 0..count-1: around the torus, or to the border.
    int bounded(int place, int count) const {
        if (!wraps) return place < 0 ? 0 : (place >= count ? count - 1 : place);
        const int rest = place % count;
        return rest < 0 ? rest + count : rest;
    }

  private:
    static int whole(double place) {
        constexpr double most = 1e9;
        if (!(place > -most)) return -1'000'000'000;
        return place < most ? static_cast<int>(std::floor(place)) : 1'000'000'000;
    }
};

/// A frame around most of the balls, with cells of at least `cell` length, and no more than about
/// `cells_a_ball`. A function of the world alone; it changes seldom while the balls move about.
CellFrame frame_around(const World& world, double cell, double cells_a_ball = 4.0);

/// A frame around most of the points, on a plane; cells as above.
CellFrame frame_around(std::span<const Vec2> points, double cell, double cells_a_point = 4.0);

/// Rough area a ball, where most of them are, length^2; 0 without balls.
double area_per_ball(const World& world);

/// Radius of the largest ball; 0 without balls.
double largest_radius(const Balls& balls);

/// On a torus, the shortest displacement from b to a. `offset`: a - b; any images will do. `torus`:
/// its width and height.
inline Vec2 nearest_image(Vec2 offset, Vec2 torus) {
    return {offset.x - torus.x * std::floor(offset.x / torus.x + 0.5),
            offset.y - torus.y * std::floor(offset.y / torus.y + 0.5)};
}

/// `position` brought into the torus: low included, high excluded.
Vec2 wrapped(Vec2 position, const Box& torus);

}  // namespace carom
