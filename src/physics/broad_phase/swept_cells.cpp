#include "physics/broad_phase/swept_cells.h"

#include <algorithm>

namespace carom {

namespace {

SweptCells::Range joined(const SweptCells::Range& a, const SweptCells::Range& b) {
    return {std::min(a.low_column, b.low_column), std::max(a.high_column, b.high_column),
            std::min(a.low_row, b.low_row), std::max(a.high_row, b.high_row)};
}

}  // namespace

void SweptCells::reset(const CellFrame& frame, std::size_t balls) {
    frame_ = frame;
    head_.assign(frame.count(), none);
    entries_.clear();
    for (const std::uint32_t ball : wide_)
        is_wide_[ball] = 0;
    wide_.clear();
    is_wide_.resize(balls, 0);
    ranges_.resize(balls);
    seen_.resize(balls, round_);
}

// Rounds go on from one reset to the next, until there are no more numbers.
void SweptCells::begin_round() {
    if (++round_ != 0) return;
    seen_.assign(seen_.size(), 0);
    round_ = 1;
}

SweptCells::Range SweptCells::range_of(const Box& box) const {
    if (!frame_.wraps)
        return {frame_.column(box.low.x), frame_.column(box.high.x), frame_.row(box.low.y),
                frame_.row(box.high.y)};
    Range range{frame_.column_unbounded(box.low.x), frame_.column_unbounded(box.high.x),
                frame_.row_unbounded(box.low.y), frame_.row_unbounded(box.high.y)};
    range.high_column = std::min(range.high_column, range.low_column + frame_.columns);
    range.high_row = std::min(range.high_row, range.low_row + frame_.rows);
    return range;
}

void SweptCells::enter(std::uint32_t index, const Box& box, bool is_first) {
    if (is_wide_[index] != 0) return;
    const Range old = is_first ? Range{} : ranges_[index];
    const Range now = is_first ? range_of(box) : joined(old, range_of(box));
    const std::int64_t columns = now.high_column - now.low_column + 1;
    const std::int64_t rows = now.high_row - now.low_row + 1;
    if (columns * rows > most_cells) {
        wide_.push_back(index);
        is_wide_[index] = 1;
        return;
    }
    ranges_[index] = now;
    const auto was_there = [&](int column, int row) {
        return column >= old.low_column && column <= old.high_column && row >= old.low_row &&
               row <= old.high_row;
    };
    for (int row = now.low_row; row <= now.high_row; ++row) {
        for (int column = now.low_column; column <= now.high_column; ++column) {
            if (was_there(column, row)) continue;
            std::uint32_t& head = head_[frame_.index(frame_.bounded(column, frame_.columns),
                                                     frame_.bounded(row, frame_.rows))];
            entries_.push_back({index, head});
            head = static_cast<std::uint32_t>(entries_.size() - 1);
        }
    }
}

}  // namespace carom
