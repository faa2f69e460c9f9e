#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes.h"

/// A hierarchical grid: tells whether a disc overlaps any disc added before, whatever their sizes.
namespace carom {

/// Each level is a grid for radii within a factor of 2, so that a query visits at most nine cells
/// of each level. Discs must be added, and queried, from large to small.
class HierarchicalGrid {
  public:
    /// `radii` are those of all discs to be added. Pre: sorted from large to small; all > 0.
    HierarchicalGrid(const Box& box, const std::vector<double>& radii);

    /// Adds a disc. Pre: its centre lies in the box.
    void add(const Disc& disc);
    /// Whether the disc overlaps a disc added before. Adds the rows of cells and the discs that it
    /// looked at to `looks`. Pre: the disc is no larger than those added.
    bool touches(const Disc& disc, std::uint64_t& looks) const;

  private:
    struct Grid {
        double largest = 0.0;  ///< radius; the next level has half of it
        double cell = 0.0;
        int columns = 0;
        int rows = 0;
        std::vector<std::int32_t> first;  ///< first disc of each cell; -1: none
    };
    int column(const Grid& grid, double x) const;
    int row(const Grid& grid, double y) const;

    Box box_;
    std::vector<Grid> grids_;
    std::vector<Disc> discs_;
    std::vector<std::int32_t> next_;  ///< the next disc of the same cell; -1: none
};

}  // namespace carom
