#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/world.h"

/// The broad phase: the plane cut into equal cells, so that only neighbours are compared.
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
    int column(double x) const { return bounded(column_unbounded(x), columns); }
    int row(double y) const { return bounded(row_unbounded(y), rows); }
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

/// The same around points that stand for something else, on a plane.
CellFrame frame_around(const std::vector<Vec2>& points, double cell, double cells_a_point = 4.0);

/// Area for each ball where most of them are, length^2, roughly; 0 without balls.
double room_of_a_ball(const World& world);

/// Radius of the largest ball; 0 without balls.
double largest_radius(const Balls& balls);

/// The shortest way from b to a: `offset` = a - b, or on a torus the nearest image of it.
/// Pre: both lie within one torus width of each other's images.
inline Vec2 nearest_image(Vec2 offset, Vec2 torus) {
    return {offset.x - torus.x * std::floor(offset.x / torus.x + 0.5),
            offset.y - torus.y * std::floor(offset.y / torus.y + 0.5)};
}

/// `position` brought into the torus: low included, high excluded.
Vec2 wrapped(Vec2 position, const Box& torus);

/// Balls in cells, each in the cell of its centre.
class PointCells {
  public:
    static constexpr std::uint32_t none = 0xffffffffu;

    void rebuild(const CellFrame& frame, const std::vector<Vec2>& positions);
    /// Ball `index` is now at `position`.
    void move(std::size_t index, Vec2 position);

    const CellFrame& frame() const { return frame_; }
    std::uint32_t cell_of(std::size_t index) const { return cell_[index]; }

    /// Calls visit(other index) for every ball in the ball's own cell and the eight around it,
    /// itself included, each once.
    template <typename Visit>
    void for_each_near(std::size_t index, Visit&& visit) const {
        const int column = static_cast<int>(cell_[index] % static_cast<unsigned>(frame_.columns));
        const int row = static_cast<int>(cell_[index] / static_cast<unsigned>(frame_.columns));
        const int across = std::min(3, frame_.wraps ? frame_.columns : 3);
        const int along = std::min(3, frame_.wraps ? frame_.rows : 3);
        for (int j = 0; j < along; ++j) {
            int y = row - 1 + j;
            if (frame_.wraps) y = frame_.bounded(y, frame_.rows);
            if (y < 0 || y >= frame_.rows) continue;
            for (int i = 0; i < across; ++i) {
                int x = column - 1 + i;
                if (frame_.wraps) x = frame_.bounded(x, frame_.columns);
                if (x < 0 || x >= frame_.columns) continue;
                for (std::uint32_t other = head_[frame_.index(x, y)]; other != none;
                     other = next_[other])
                    visit(other);
            }
        }
    }

  private:
    void insert(std::uint32_t index, std::uint32_t cell);

    CellFrame frame_;
    std::vector<std::uint32_t> head_;  // first ball of each cell
    std::vector<std::uint32_t> next_;  // by ball
    std::vector<std::uint32_t> before_;
    std::vector<std::uint32_t> cell_;
};

}  // namespace carom
