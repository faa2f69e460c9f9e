#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "physics/cell_frame.h"
#include "physics/event_path.h"
#include "physics/large_pages.h"

/// The broad phase of the solver `event`: each ball in the cell of its centre, moved from cell to
/// cell by events. A few balls much larger than the rest (*giants*) are in no cell: everybody looks
/// at them, so that cells can fit the others.
///
/// What a walk over neighbours reads of a ball stands in the ball (EventBall::next, and the tori of
/// its path), next to what the walk is for.
namespace carom {

template <typename Real>
class EventCells {
  public:
    using Balls = LargeVector<EventBall<Real>>;
    static constexpr std::uint32_t none = EventBall<Real>::none;

    /// A frame whose cells are at least as wide as the largest ball that is no giant, and every
    /// ball in it. Pre: `balls` are as many as the world's.
    void reset(const World& world, Balls& balls);

    /// Whether `reset` would choose the same frame now. Pre: the radii are still the same.
    bool suits(const World& world) const { return frame_for(world) == frame_; }

    const CellFrame& frame() const { return frame_; }
    /// Largest radius among those that are in cells.
    double largest() const { return largest_; }
    const std::vector<std::uint32_t>& giants() const { return giants_; }

    /// Cells are counted without bound, so that on a torus they say in which image a path is.
    int column(std::uint32_t ball) const { return places_[ball].column; }
    int row(std::uint32_t ball) const { return places_[ball].row; }
    std::uint32_t cell(std::uint32_t ball) const { return places_[ball].cell; }

    void enter(Balls& balls, std::uint32_t ball, Vec2 position);
    void leave(Balls& balls, std::uint32_t ball);
    /// To the next cell; (columns, rows) is one of the four steps.
    void step(Balls& balls, std::uint32_t ball, int columns, int rows);
    /// The path has been moved by whole tori.
    void shift(Balls& balls, std::uint32_t ball, int across, int along) {
        places_[ball].column += across * frame_.columns;
        places_[ball].row += along * frame_.rows;
        EventPath<Real>& path = balls[ball].path;
        path.across = static_cast<std::int8_t>(path.across + across);
        path.along = static_cast<std::int8_t>(path.along + along);
    }

    /// Calls visit(other, tori across, tori along) for every ball in the nine cells around the
    /// ball's own, itself left out: the image of the other that is near lies that many tori from
    /// its path.
    template <typename Visit>
    void for_each_near(const Balls& balls, std::uint32_t ball, Visit&& visit) const {
        if (frame_.wraps)
            walk<true>(balls, ball, {-1, -1}, {1, 1}, visit);
        else
            walk<false>(balls, ball, {-1, -1}, {1, 1}, visit);
    }
    /// The same in those three of the nine cells that a step of (columns, rows) has brought near.
    template <typename Visit>
    void for_each_new(const Balls& balls, std::uint32_t ball, int columns, int rows,
                      Visit&& visit) const {
        const Step low{columns == 0 ? -1 : columns, rows == 0 ? -1 : rows};
        const Step high{columns == 0 ? 1 : columns, rows == 0 ? 1 : rows};
        if (frame_.wraps)
            walk<true>(balls, ball, low, high, visit);
        else
            walk<false>(balls, ball, low, high, visit);
    }

  private:
    struct Step {
        int columns = 0;
        int rows = 0;
    };
    struct Cell {
        int column = 0;
        int row = 0;
        std::uint32_t cell = 0;
        std::uint32_t before = none;  ///< ball in the same cell
    };
    /// A cell of the frame on one axis, and how many tori the way to it has crossed. Pre: on a
    /// torus place is in -1..count.
    struct Place {
        int place = 0;
        int tori = 0;
    };
    static Place around(int place, int count) {
        if (place < 0) return {place + count, -1};
        return place < count ? Place{place, 0} : Place{place - count, 1};
    }

    template <bool wraps, typename Visit>
    void walk(const Balls& all, std::uint32_t ball, Step low, Step high, Visit&& visit) const {
        // What a visit writes cannot change these, but no compiler knows that.
        const EventBall<Real>* const balls = all.data();
        const std::uint32_t* const heads = head_.data();
        const Cell own = places_[ball];
        const int columns = frame_.columns;
        const int rows = frame_.rows;
        const auto index = [columns](int column, int row) {
            return static_cast<std::ptrdiff_t>(row) * columns + column;
        };
        if constexpr (wraps) {
            const int across = balls[ball].path.across;
            const int along = balls[ball].path.along;
            const int column = own.column - across * columns;
            const int row = own.row - along * rows;
            for (int j = row + low.rows; j <= row + high.rows; ++j) {
                const Place y = around(j, rows);
                for (int i = column + low.columns; i <= column + high.columns; ++i) {
                    const Place x = around(i, columns);
                    for (std::uint32_t other = heads[index(x.place, y.place)]; other != none;
                         other = balls[other].next)
                        if (other != ball)
                            visit(other, across + x.tori - balls[other].path.across,
                                  along + y.tori - balls[other].path.along);
                }
            }
        } else {
            const int bottom = std::max(own.row + low.rows, 0);
            const int top = std::min(own.row + high.rows, rows - 1);
            const int left = std::max(own.column + low.columns, 0);
            const int right = std::min(own.column + high.columns, columns - 1);
            // All at once from memory, where there are too many for the cache.
            for (int y = bottom; y <= top; ++y)
                for (int x = left; x <= right; ++x) {
                    const std::uint32_t first = heads[index(x, y)];
                    if (first != none) __builtin_prefetch(&balls[first].path.quick);
                }
            for (int y = bottom; y <= top; ++y)
                for (int x = left; x <= right; ++x)
                    for (std::uint32_t other = heads[index(x, y)]; other != none;
                         other = balls[other].next)
                        if (other != ball) visit(other, 0, 0);
        }
    }
    CellFrame frame_for(const World& world) const;
    void link(Balls& balls, std::uint32_t ball);

    CellFrame frame_;
    double largest_ = 0.0;
    std::vector<std::uint32_t> by_size_;
    std::vector<std::uint32_t> giants_;
    LargeVector<std::uint32_t> head_;  ///< first ball of each cell
    LargeVector<Cell> places_;
};

}  // namespace carom
