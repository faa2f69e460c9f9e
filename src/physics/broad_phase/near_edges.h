#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/disc_grid.h"
#include "physics/broad_phase/edge_map.h"
#include "physics/broad_phase/pairs.h"

namespace carom {

/// How far around a disc edges are looked for, from surface to surface.
struct EdgeMargin {
    double least = 0.0;  ///< length
    double share = 0.0;  ///< of the disc's radius

    double of(double radius) const { return std::max(least, share * radius); }
};

/// The edges near each disc of a grid: for each level of the grid, the edges are in its cells, or,
/// where few discs are among many edges, on a map of their own. Held capsules are left out.
class NearEdges {
  public:
    /// Finds them anew. `centers` and `radii` are those of which `grid` was built. `uses_map`:
    /// edges are on a map, not in cells. Pre: uses_map only if EdgeMap::suits(world).
    void find(const World& world, const DiscGrid& grid, std::span<const Vec2> centers,
              std::span<const double> radii, EdgeMargin margin, bool uses_map);

    /// In ascending order.
    std::span<const EdgePair> all() const { return pairs_; }
    std::span<const EdgePair> of(std::uint32_t disc) const;
    /// Calls visit(pair) for the edges that a disc of the grid may touch if it is at `position`,
    /// which may be further away than the margin; perhaps for some that it does not. Pre: no map.
    template <typename Visit>
    void for_each_at(const DiscGrid& grid, std::uint32_t disc, Vec2 position, Visit&& visit) const {
        if (cells_.empty()) return;
        const std::size_t level = grid.level_of(disc);
        const CellFrame& frame = grid.frame(level);
        const std::uint32_t cell = frame.index(frame.column(position.x), frame.row(position.y));
        for (const CapsuleEntry entry : cells_[level].in_cell(cell))
            visit(EdgePair{disc, entry.index, entry.along, entry.across});
    }

    bool has_map() const { return has_map_; }
    /// Pre: has_map().
    EdgeMap& map() { return map_; }

  private:
    void find_in_cells(const World& world, const DiscGrid& grid, std::span<const Vec2> centers,
                       std::span<const double> radii, EdgeMargin margin);
    void find_on_map(const World& world, std::span<const Vec2> centers,
                     std::span<const double> radii, EdgeMargin margin);

    std::vector<CapsuleCells> cells_;  // by level of the grid
    bool has_map_ = false;
    EdgeMap map_;
    std::vector<EdgePair> pairs_;
    std::vector<std::uint8_t> has_any_;  // by disc
};

}  // namespace carom
