#pragma once

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
    int tori_across(std::uint32_t ball) const { return tori(column_[ball], frame_.columns); }
    int tori_along(std::uint32_t ball) const { return tori(row_[ball], frame_.rows); }

    void enter(std::uint32_t ball, Vec2 position);
    void leave(std::uint32_t ball);
    /// To the next cell; (columns, rows) is one of the four steps.
    void step(std::uint32_t ball, int columns, int rows);
    /// The path has been moved by whole tori.
    void shift(std::uint32_t ball, int across, int along) {
        column_[ball] += across * frame_.columns;
        row_[ball] += along * frame_.rows;
    }

    /// Calls visit(other, tori across, tori along) for every ball in the nine cells around the
    /// ball's own, itself left out: the image of the other that is near lies that many tori from
    /// its path.
    template <typename Visit>
    void for_each_near(std::uint32_t ball, Visit&& visit) const {
        for (int j = row_[ball] - 1; j <= row_[ball] + 1; ++j) {
            if (!frame_.wraps && (j < 0 || j >= frame_.rows)) continue;
            const int y = frame_.bounded(j, frame_.rows);
            for (int i = column_[ball] - 1; i <= column_[ball] + 1; ++i) {
                if (!frame_.wraps && (i < 0 || i >= frame_.columns)) continue;
                const int x = frame_.bounded(i, frame_.columns);
                for (std::uint32_t other = head_[frame_.index(x, y)]; other != none;
                     other = next_[other]) {
                    if (other == ball) continue;
                    if (frame_.wraps)
                        visit(other, (i - column_[other]) / frame_.columns,
                              (j - row_[other]) / frame_.rows);
                    else
                        visit(other, 0, 0);
                }
            }
        }
    }

  private:
    int tori(int place, int count) const {
        return frame_.wraps ? (place - frame_.bounded(place, count)) / count : 0;
    }
    void link(std::uint32_t ball);

    CellFrame frame_;
    double largest_ = 0.0;
    std::vector<std::uint32_t> giants_;
    std::vector<std::uint8_t> is_giant_;
    std::vector<std::uint32_t> head_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> before_;
    std::vector<std::uint32_t> cell_;
    std::vector<int> column_;
    std::vector<int> row_;
};

}  // namespace carom
