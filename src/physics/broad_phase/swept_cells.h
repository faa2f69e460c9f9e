#pragma once

#include <cstdint>
#include <vector>

#include "physics/broad_phase/cell_frame.h"
#include "physics/memory/prefetch.h"

/// The broad phase of discs that change their paths: each enters every cell that its path can
/// touch.
namespace carom {

class SweptCells {
  public:
    /// Cells, in a torus counted without bound.
    struct Range {
        int low_column = 0;
        int high_column = -1;
        int low_row = 0;
        int high_row = -1;
    };

    /// Empty cells, for so many balls.
    void reset(const CellFrame& frame, std::size_t balls);

    const CellFrame& frame() const { return frame_; }

    /// Ball `index` may be anywhere in `box` until further notice. `is_first`: it has not entered
    /// any cell since the last `reset`.
    void enter(std::uint32_t index, const Box& box, bool is_first);

    /// Fetches from memory what tells where the ball has been, and who has entered the cells around
    /// this place.
    void fetch(std::uint32_t index, Vec2 place) const {
        fetch_early(&ranges_[index]);
        fetch_early(&seen_[index]);
        const int column = frame_.column(place.x);
        const int row = frame_.row(place.y);
        for (int step = -1; step <= 1; ++step)
            fetch_early(&head_[frame_.index(column, frame_.bounded(row + step, frame_.rows))]);
    }

    /// The cells that `box` touches.
    Range range_of(const Box& box) const;

    /// Calls visit(other) for each ball that has entered a cell of `range`, each once.
    template <typename Visit>
    void for_each_in(const Range& range, Visit&& visit) {
        begin_round();
        for_each_cell(range, [&](std::uint32_t cell, int, int) {
            for (std::uint32_t at = head_[cell]; at != none; at = entries_[at].next) {
                const std::uint32_t other = entries_[at].ball;
                if (seen_[other] == round_) continue;
                seen_[other] = round_;
                visit(other);
            }
        });
    }

    /// Calls visit(cell, tori across, tori along) for each cell of `range`; the tori are those that
    /// an unwrapped path there has left behind (0 without a torus).
    template <typename Visit>
    void for_each_cell(const Range& range, Visit&& visit) const {
        for (int row = range.low_row; row <= range.high_row; ++row) {
            const int y = frame_.bounded(row, frame_.rows);
            for (int column = range.low_column; column <= range.high_column; ++column) {
                const int x = frame_.bounded(column, frame_.columns);
                visit(frame_.index(x, y), frame_.wraps ? (column - x) / frame_.columns : 0,
                      frame_.wraps ? (row - y) / frame_.rows : 0);
            }
        }
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    struct Entry {
        std::uint32_t ball = 0;
        std::uint32_t next = none;
    };

    void begin_round();

    CellFrame frame_;
    std::vector<Range> ranges_;  // by ball; only of those that have entered cells
    std::vector<std::uint32_t> head_;
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> seen_;  // by ball: in which round
    std::uint32_t round_ = 0;
};

}  // namespace carom
