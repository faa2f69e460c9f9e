#pragma once

#include <cstdint>
#include <vector>

#include "physics/broad_phase/cell_frame.h"
#include "physics/memory/prefetch.h"

namespace carom {

/// A dynamic grid of boxes around paths: a ball is inserted into every cell that its path can
/// touch, and into more when its path changes: into the rectangle of cells round its old and new
/// boxes. Entries of an old path stay, which costs queries a test. A ball has one entry in a cell
/// at most, however often its path changes to and fro.
///
/// A ball whose rectangle has more than `most_cells` cells is on a list beside them: entering each
/// cell would cost more than to test it in every query, and a query for such a path would pass over
/// an entry of each other one in each cell.
class SweptCells {
  public:
    /// A rectangle of cells. On a torus, columns and rows are counted without bound.
    struct Range {
        int low_column = 0;
        int high_column = -1;
        int low_row = 0;
        int high_row = -1;
    };

    /// Empties all cells, for so many balls.
    void reset(const CellFrame& frame, std::size_t balls);

    const CellFrame& frame() const { return frame_; }

    /// The path of ball `index` is in `box` from now on. `is_first`: it has not entered any cell
    /// since the last `reset`.
    void enter(std::uint32_t index, const Box& box, bool is_first);

    /// Prefetches which cells the ball has entered, and the entries of the cells around `place`.
    void fetch(std::uint32_t index, Vec2 place) const {
        prefetch_line(&ranges_[index]);
        prefetch_line(&seen_[index]);
        const int column = frame_.column(place.x);
        const int row = frame_.row(place.y);
        for (int step = -1; step <= 1; ++step)
            prefetch_line(&head_[frame_.index(column, frame_.bounded(row + step, frame_.rows))]);
    }

    /// In all cells: what the cells of queries can hold.
    std::size_t entry_count() const { return entries_.size(); }

    /// The cells that `box` touches.
    Range range_of(const Box& box) const;

    /// Calls visit(other) for each ball that has entered a cell of `range`, and for each one with
    /// a wide box, each once.
    template <typename Visit>
    void for_each_in(const Range& range, Visit&& visit) {
        begin_round();
        for (const std::uint32_t other : wide_) {
            seen_[other] = round_;
            visit(other);
        }
        for_each_cell(range, [&](std::uint32_t cell, int, int) {
            for (std::uint32_t at = head_[cell]; at != none; at = entries_[at].next) {
                const std::uint32_t other = entries_[at].ball;
                if (seen_[other] == round_) continue;
                seen_[other] = round_;
                visit(other);
            }
        });
    }

    /// Calls visit(cell, across, along) for each cell of `range`, with the periodic image index in
    /// which it lies: widths and heights of the torus (0 on a plane).
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
    static constexpr std::int64_t most_cells = 256;
    struct Entry {
        std::uint32_t ball = 0;
        std::uint32_t next = none;
    };

    void begin_round();

    CellFrame frame_;
    std::vector<Range> ranges_;  // by ball: the cells that it has entered, unless it is wide
    std::vector<std::uint32_t> head_;
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> wide_;    // since the last reset
    std::vector<std::uint8_t> is_wide_;  // by ball
    std::vector<std::uint32_t> seen_;    // by ball: in which round
    std::uint32_t round_ = 0;
};

}  // namespace carom
