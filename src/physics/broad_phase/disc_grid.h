#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/broad_phase/cell_frame.h"
#include "physics/memory/prefetch.h"

/// A static grid of discs: equal cells, with the discs sorted by cell, so that the neighbours of a
/// disc are three short runs of memory.
///
/// Radii may differ by orders of magnitude. Discs within a factor of two of one another share a
/// *level*, a grid whose cells are as wide as its largest disc. Each disc is compared with the nine
/// cells around it in its own level and in the coarser ones. Which pairs are found does not depend
/// on the cells; their order does, so callers that need an order sort.
///
/// A frame is kept from one `build` to the next while it still fits fairly, so that edges which
/// were put into the same cells can stay there.
namespace carom {

class DiscGrid {
  public:
    /// Sorts the discs into cells; each reaches `margin` beyond its radius. On a torus the centres
    /// lie in it. Any numbers are accepted: a disc whose centre is not a number is in no pair.
    /// Allocates only where it holds more than ever before.
    void build(std::span<const Vec2> centers, std::span<const double> radii, double margin,
               const std::optional<Box>& torus);

    /// Calls visit(i, j) once for every pair of discs whose centres (on a torus: nearest images)
    /// are nearer than radius i + radius j + 2 margin.
    template <typename Visit>
    void for_each_pair(Visit&& visit) const;

    /// Calls visit(i) once for every disc (on a torus: nearest image) that reaches nearer than
    /// `reach` to `center`. `center` may lie outside of the torus.
    template <typename Visit>
    void for_each_near(Vec2 center, double reach, Visit&& visit) const;

    /// To hide cache misses, call `fetch_starts(p)`, later `fetch_places(p)`, then query near `p`.
    /// Both know the finest level only.
    void fetch_starts(Vec2 place) const {
        for_each_row_around(place,
                            [&](std::uint32_t low, std::uint32_t) { prefetch_line(&start_[low]); });
    }
    void fetch_places(Vec2 place) const {
        for_each_row_around(place, [&](std::uint32_t low, std::uint32_t high) {
            if (start_[low] == start_[high + 1]) return;
            prefetch_line(&places_[start_[low]]);
            prefetch_line(&places_[start_[high + 1] - 1]);
        });
    }
    /// Calls visit(i) for each disc of the finest level in the nine cells around `place`.
    template <typename Visit>
    void for_each_around(Vec2 place, Visit&& visit) const {
        for_each_row_around(place, [&](std::uint32_t low, std::uint32_t high) {
            for (std::uint32_t at = start_[low]; at < start_[high + 1]; ++at)
                visit(places_[at].disc);
        });
    }

    /// Levels from the coarsest to the finest, at least one; some may be empty.
    std::size_t levels() const { return levels_.size(); }
    const CellFrame& finest() const { return levels_.back().frame; }
    const CellFrame& frame(std::size_t level) const { return levels_[level].frame; }
    std::size_t level_of(std::uint32_t disc) const {
        std::size_t level = levels_.size() - 1;
        while (cell_[disc] < levels_[level].first)
            --level;
        return level;
    }
    /// No disc of the level reaches further than this from its centre. Kept as long as the frame.
    double reach(std::size_t level) const { return 0.5 * kept_[level].side; }
    /// Calls visit(i) for each disc of the cell, ascending.
    template <typename Visit>
    void for_each_in_cell(std::size_t level, int column, int row, Visit&& visit) const {
        const std::uint32_t cell = levels_[level].cell(column, row);
        for (std::uint32_t at = start_[cell]; at < start_[cell + 1]; ++at)
            visit(places_[at].disc);
    }

  private:
    struct Place {
        Vec2 center;
        double reach = 0.0;
        std::uint32_t disc = 0;
        std::uint32_t cell = 0;
    };

    // Cells are stored row by row, with an empty one before each row and an empty row below and
    // above, so that every cell inside has nine neighbours.
    struct Level {
        CellFrame frame;
        Vec2 per_cell;  // cells per length
        double largest = 0.0;
        std::uint32_t first = 0;  // of its cells
        std::uint32_t stride = 0;
        std::uint32_t discs = 0;

        std::uint32_t cell(int column, int row) const {
            return first + static_cast<std::uint32_t>(row + 1) * stride +
                   static_cast<std::uint32_t>(column + 1);
        }
        std::uint32_t cells() const {
            return stride * static_cast<std::uint32_t>(frame.rows + 2) + 2;
        }
    };
    // A frame of the last build.
    struct Kept {
        Box box;
        double side = 0.0;  // least width of a cell, before there were too many
        CellFrame frame;
    };
    // Cells `low` to `high` along one axis, counted without bound on a torus.
    struct Span {
        int low = 0;
        int high = -1;
    };

    void choose_levels(std::span<const Vec2> centers, std::span<const double> radii, double margin,
                       const std::optional<Box>& torus);
    void sort_by_cell(std::span<const Vec2> centers, std::span<const double> radii, double margin);
    const CellFrame& frame_for(Kept& kept, const Level& level, bool wraps) const;
    std::size_t level_for(double reach) const;
    static std::uint32_t place_along(double cells, int count);
    static Span reached(double place, double reach, int count, bool wraps);
    template <typename Visit>
    void for_each_row_around(Vec2 place, Visit&& visit) const {
        const Level& level = levels_.back();
        const Vec2 from = place - level.frame.origin;
        const auto column =
            static_cast<int>(place_along(from.x * level.per_cell.x, level.frame.columns));
        const auto row = static_cast<int>(place_along(from.y * level.per_cell.y, level.frame.rows));
        for (int step = -1; step <= 1; ++step)
            visit(level.cell(column - 1, row + step), level.cell(column + 1, row + step));
    }
    template <bool images, typename Visit>
    void pairs_within(const Level& level, Visit&& visit) const;
    template <typename Visit>
    void pairs_across_seams(const Level& level, Visit&& visit) const;
    template <typename Visit>
    void for_each_at(const Level& level, Vec2 center, double reach, Visit&& visit) const;
    template <bool images>
    bool meet(const Place& a, const Place& b) const {
        Vec2 offset = a.center - b.center;
        if (images) offset = nearest_image(offset, torus_);
        const double reach = a.reach + b.reach;
        return length_squared(offset) < reach * reach;
    }

    std::vector<Level> levels_ = std::vector<Level>(1);
    std::vector<Kept> kept_ = std::vector<Kept>(1);  // by level
    Box box_;                                        // holds most discs
    Vec2 torus_;                                     // its size
    double finest_scale_ = 0.0;                      // 1 / radius of the largest of all
    std::vector<std::uint32_t> start_{0, 0, 0, 0};   // by cell: its first place
    std::vector<std::uint32_t> cell_;                // by disc
    std::vector<Place> places_;
};

// Compares each disc with those after it in its own cell, and with the cell to the right and the
// three above.
template <bool images, typename Visit>
void DiscGrid::pairs_within(const Level& level, Visit&& visit) const {
    const std::uint32_t first = start_[level.first];
    const std::uint32_t last = start_[level.first + level.cells()];
    for (std::uint32_t at = first; at < last; ++at) {
        const Place& place = places_[at];
        const std::uint32_t* const own = &start_[place.cell];
        const std::uint32_t* const above = own + level.stride;
        for (std::uint32_t other = at + 1; other < own[2]; ++other)
            if (meet<images>(place, places_[other])) visit(place.disc, places_[other].disc);
        for (std::uint32_t other = above[-1]; other < above[2]; ++other)
            if (meet<images>(place, places_[other])) visit(place.disc, places_[other].disc);
    }
}

// On a torus: compares the last column with the first, and the top row with the bottom one.
template <typename Visit>
void DiscGrid::pairs_across_seams(const Level& level, Visit&& visit) const {
    const int columns = level.frame.columns;
    const int rows = level.frame.rows;
    const auto cells = [&](std::uint32_t a, std::uint32_t b) {
        for (std::uint32_t i = start_[a]; i < start_[a + 1]; ++i)
            for (std::uint32_t j = start_[b]; j < start_[b + 1]; ++j)
                if (meet<true>(places_[i], places_[j])) visit(places_[i].disc, places_[j].disc);
    };
    const int aside = rows > 1 ? 1 : 0;
    for (int row = 0; columns > 1 && row < rows; ++row)
        for (int step = -aside; step <= aside; ++step)
            cells(level.cell(columns - 1, row), level.cell(0, (row + step + rows) % rows));
    for (int column = 0; rows > 1 && column < columns; ++column)
        for (int step = -1; step <= 1; ++step)
            if (column + step >= 0 && column + step < columns)
                cells(level.cell(column, rows - 1), level.cell(column + step, 0));
}

template <typename Visit>
void DiscGrid::for_each_at(const Level& level, Vec2 center, double reach, Visit&& visit) const {
    const CellFrame& frame = level.frame;
    const double wide = reach + level.largest;
    const Span across = reached((center.x - frame.origin.x) * level.per_cell.x,
                                wide * level.per_cell.x, frame.columns, frame.wraps);
    const Span along = reached((center.y - frame.origin.y) * level.per_cell.y,
                               wide * level.per_cell.y, frame.rows, frame.wraps);
    const auto run = [&](int low, int high, int row) {
        const std::uint32_t last = start_[level.cell(high, row) + 1];
        for (std::uint32_t at = start_[level.cell(low, row)]; at < last; ++at)
            visit(places_[at]);
    };
    for (int j = along.low; j <= along.high; ++j) {
        const int row = frame.wraps ? frame.bounded(j, frame.rows) : j;
        if (across.low >= 0 && across.high < frame.columns) {
            run(across.low, across.high, row);
        } else if (across.high >= across.low) {  // around the seam
            const int low = frame.bounded(across.low, frame.columns);
            const int high = low + across.high - across.low;
            run(low, std::min(high, frame.columns - 1), row);
            if (high >= frame.columns) run(0, high - frame.columns, row);
        }
    }
}

template <typename Visit>
void DiscGrid::for_each_near(Vec2 center, double reach, Visit&& visit) const {
    for (const Level& level : levels_)
        if (level.discs > 0)
            for_each_at(level, center, reach, [&](const Place& place) {
                const Place here{center, reach};
                if (level.frame.wraps ? meet<true>(here, place) : meet<false>(here, place))
                    visit(place.disc);
            });
}

template <typename Visit>
void DiscGrid::for_each_pair(Visit&& visit) const {
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        const Level& level = levels_[l];
        if (level.discs == 0) continue;
        if (!level.frame.wraps) {
            pairs_within<false>(level, visit);
        } else {
            if (level.frame.columns == 1 || level.frame.rows == 1)
                pairs_within<true>(level, visit);
            else
                pairs_within<false>(level, visit);
            pairs_across_seams(level, visit);
        }
        for (std::size_t c = 0; c < l; ++c) {
            if (levels_[c].discs == 0) continue;
            const std::uint32_t last = start_[level.first + level.cells()];
            for (std::uint32_t at = start_[level.first]; at < last; ++at) {
                const Place& place = places_[at];
                for_each_at(levels_[c], place.center, place.reach, [&](const Place& other) {
                    if (level.frame.wraps ? meet<true>(place, other) : meet<false>(place, other))
                        visit(place.disc, other.disc);
                });
            }
        }
    }
}

}  // namespace carom
