#include "physics/broad_phase/near_edges.h"

namespace carom {

void NearEdges::find(const World& world, const DiscGrid& grid, std::span<const Vec2> centers,
                     std::span<const double> radii, EdgeMargin margin, bool uses_map) {
    has_map_ = uses_map;
    for (const EdgePair& pair : pairs_)
        if (pair.ball < has_any_.size()) has_any_[pair.ball] = 0;
    pairs_.clear();
    has_any_.resize(centers.size(), 0);
    if (!world.model().ball_edge) {
        cells_.clear();
        return;
    }
    if (has_map_)
        find_on_map(world, centers, radii, margin);
    else
        find_in_cells(world, grid, centers, radii, margin);
    std::sort(pairs_.begin(), pairs_.end());
    for (const EdgePair& pair : pairs_)
        has_any_[pair.ball] = 1;
}

void NearEdges::find_in_cells(const World& world, const DiscGrid& grid,
                              std::span<const Vec2> centers, std::span<const double> radii,
                              EdgeMargin margin) {
    // Not fewer: levels come and go with the lengths of paths.
    if (cells_.size() < grid.levels()) cells_.resize(grid.levels());
    for (std::size_t level = 0; level < grid.levels(); ++level) {
        const CellFrame& frame = grid.frame(level);
        CapsuleCells& cells = cells_[level];
        cells.update(world, frame, (1.0 + margin.share) * grid.reach(level));
        for (const std::uint32_t cell : cells.occupied()) {
            const int column = static_cast<int>(cell % static_cast<std::uint32_t>(frame.columns));
            const int row = static_cast<int>(cell / static_cast<std::uint32_t>(frame.columns));
            grid.for_each_in_cell(level, column, row, [&](std::uint32_t disc) {
                for (const CapsuleEntry entry : cells.in_cell(cell)) {
                    const EdgePair pair{disc, entry.index, entry.along, entry.across};
                    const double reach = radii[disc] + margin.of(radii[disc]);
                    if (overlaps_edge(world, pair, {centers[disc], reach})) pairs_.push_back(pair);
                }
            });
        }
    }
}

void NearEdges::find_on_map(const World& world, std::span<const Vec2> centers,
                            std::span<const double> radii, EdgeMargin margin) {
    map_.update(world);
    for (std::uint32_t i = 0; i < centers.size(); ++i) {
        const Disc disc{centers[i], radii[i] + margin.of(radii[i])};
        map_.for_each_near(bounds(disc), [&](std::uint32_t capsule) {
            const EdgePair pair{i, capsule, 0, 0};
            if (overlaps_edge(world, pair, disc)) pairs_.push_back(pair);
        });
    }
}

std::span<const EdgePair> NearEdges::of(std::uint32_t disc) const {
    if (!has_any_[disc]) return {};
    const auto first = std::ranges::lower_bound(pairs_, disc, {}, &EdgePair::ball);
    auto last = first;
    while (last != pairs_.end() && last->ball == disc)
        ++last;
    return {first, last};
}

}  // namespace carom
