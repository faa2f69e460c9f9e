#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "physics/cell_frame.h"

/// The broad phase of the solver `event`: each ball in the cell of its centre, moved from cell to
/// cell by events. A few balls much larger than the rest (*giants*) are in no cell: everybody looks
/// at them, so that cells can fit the others.
namespace carom {

class EventCells {
  public:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// A frame whose cells are at least as wide as the largest ball that is no giant. Balls enter
    /// afterwards, each once.
    void reset(const World& world, const std::vector<Vec2>& positions);

    /// Whether `reset` would choose the same frame now. Pre: the radii are still the same.
    bool suits(const World& world) const { return frame_for(world) == frame_; }

    const CellFrame& frame() const { return frame_; }
    /// Largest radius among those that are in cells.
    double largest() const { return largest_; }
    bool is_giant(std::uint32_t ball) const { return is_giant_[ball] != 0; }
    const std::vector<std::uint32_t>& giants() const { return giants_; }

    /// Cells are counted without bound, so that on a torus they say in which image a path is.
    int column(std::uint32_t ball) const { return column_[ball]; }
    int row(std::uint32_t ball) const { return row_[ball]; }
    std::uint32_t cell(std::uint32_t ball) const { return cell_[ball]; }
    /// Tori that lie between the ball's path and its image in the frame.
    int tori_across(std::uint32_t ball) const { return frame_.wraps ? tori_[ball].across : 0; }
    int tori_along(std::uint32_t ball) const { return frame_.wraps ? tori_[ball].along : 0; }

    void enter(std::uint32_t ball, Vec2 position);
    void leave(std::uint32_t ball);
    /// To the next cell; (columns, rows) is one of the four steps.
    void step(std::uint32_t ball, int columns, int rows);
    /// The path has been moved by whole tori.
    void shift(std::uint32_t ball, int across, int along) {
        column_[ball] += across * frame_.columns;
        row_[ball] += along * frame_.rows;
        tori_[ball].across += across;
        tori_[ball].along += along;
    }

    /// Calls visit(other, tori across, tori along) for every ball in the nine cells around the
    /// ball's own, itself left out: the image of the other that is near lies that many tori from
    /// its path.
    template <typename Visit>
    void for_each_near(std::uint32_t ball, Visit&& visit) const {
        if (frame_.wraps)
            walk<true>(ball, {-1, -1}, {1, 1}, visit);
        else
            walk<false>(ball, {-1, -1}, {1, 1}, visit);
    }
    /// The same in those three of the nine cells that a step of (columns, rows) has brought near.
    template <typename Visit>
    void for_each_new(std::uint32_t ball, int columns, int rows, Visit&& visit) const {
        const Step low{columns == 0 ? -1 : columns, rows == 0 ? -1 : rows};
        const Step high{columns == 0 ? 1 : columns, rows == 0 ? 1 : rows};
        if (frame_.wraps)
            walk<true>(ball, low, high, visit);
        else
            walk<false>(ball, low, high, visit);
    }

  private:
    struct Step {
        int columns = 0;
        int rows = 0;
    };
    struct Tori {
        int across = 0;
        int along = 0;
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
    void walk(std::uint32_t ball, Step low, Step high, Visit&& visit) const {
        if constexpr (wraps) {
            const Tori own = tori_[ball];
            const int column = column_[ball] - own.across * frame_.columns;
            const int row = row_[ball] - own.along * frame_.rows;
            for (int j = row + low.rows; j <= row + high.rows; ++j) {
                const Place y = around(j, frame_.rows);
                for (int i = column + low.columns; i <= column + high.columns; ++i) {
                    const Place x = around(i, frame_.columns);
                    for (std::uint32_t other = head_[frame_.index(x.place, y.place)]; other != none;
                         other = next_[other])
                        if (other != ball)
                            visit(other, own.across + x.tori - tori_[other].across,
                                  own.along + y.tori - tori_[other].along);
                }
            }
        } else {
            const int bottom = std::max(row_[ball] + low.rows, 0);
            const int top = std::min(row_[ball] + high.rows, frame_.rows - 1);
            const int left = std::max(column_[ball] + low.columns, 0);
            const int right = std::min(column_[ball] + high.columns, frame_.columns - 1);
            for (int y = bottom; y <= top; ++y)
                for (int x = left; x <= right; ++x)
                    for (std::uint32_t other = head_[frame_.index(x, y)]; other != none;
                         other = next_[other])
                        if (other != ball) visit(other, 0, 0);
        }
    }
    CellFrame frame_for(const World& world) const;
    void link(std::uint32_t ball);

    CellFrame frame_;
    double largest_ = 0.0;
    std::vector<std::uint32_t> by_size_;
    std::vector<std::uint32_t> giants_;
    std::vector<std::uint8_t> is_giant_;
    std::vector<std::uint32_t> head_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> before_;
    std::vector<std::uint32_t> cell_;
    std::vector<int> column_;
    std::vector<int> row_;
    std::vector<Tori> tori_;  ///< empty unless on a torus
};

}  // namespace carom
