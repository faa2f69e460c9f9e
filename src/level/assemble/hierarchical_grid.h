#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes.h"

/// Which part of a box is taken by discs of any sizes.
namespace carom {

/// One grid of cells for each halving of the radius, so that a question looks at no more than nine
/// cells a grid. Discs must be added, and asked for, from large to small.
class HierarchicalGrid {
  public:
    /// Pre: `radii` are those of the discs to come, from large to small; all > 0.
    HierarchicalGrid(const Box& box, const std::vector<double>& radii);

    /// Pre: the centre lies in the box.
    void add(const Disc& disc);
    /// Whether the disc overlaps one that was added. Pre: it is no larger than those.
    bool touches(const Disc& disc) const;

  private:
    struct Grid {
        double largest = 0.0;  ///< radius; the next grid begins at half of it
        double cell = 0.0;
        int columns = 0;
        int rows = 0;
        std::vector<std::int32_t> first;  ///< disc in each cell; -1: none
    };
    int column(const Grid& grid, double x) const;
    int row(const Grid& grid, double y) const;

    Box box_;
    std::vector<Grid> grids_;
    std::vector<Disc> discs_;
    std::vector<std::int32_t> next_;  ///< the next disc in the same cell
};

}  // namespace carom
