#pragma once

#include <cstdint>
#include <vector>

#include "physics/broad_phase/capsule_cells.h"

namespace carom {

/// The edges in cells that fit them: for a few balls among many edges, as on a pinball table. Cells
/// that fit the balls would move with them, and every edge would have to enter them again.
class EdgeMap {
  public:
    /// Whether it is cheaper than cells that fit the balls: no torus, and over 8 edges a ball.
    static bool suits(const World& world);

    /// Enters the edges where they are now; held ones are left out. Pre: suits(world).
    void update(const World& world);

    /// Calls visit(capsule) for each edge, by index, that `box` can touch, and perhaps for some
    /// others, each once, in no particular order.
    template <typename Visit>
    void for_each_near(const Box& box, Visit&& visit) {
        ++round_;
        const int right = frame_.column(box.high.x);
        const int top = frame_.row(box.high.y);
        for (int row = frame_.row(box.low.y); row <= top; ++row) {
            for (int column = frame_.column(box.low.x); column <= right; ++column) {
                for (const CapsuleEntry entry : cells_.in_cell(frame_.index(column, row))) {
                    if (seen_[entry.index] == round_) continue;
                    seen_[entry.index] = round_;
                    visit(entry.index);
                }
            }
        }
    }

  private:
    CellFrame frame_;
    CapsuleCells cells_;
    std::vector<Vec2> middles_;
    std::vector<std::uint64_t> seen_;  ///< in which round, by capsule
    std::uint64_t round_ = 0;
};

}  // namespace carom
