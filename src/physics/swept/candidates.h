#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/neighbour_list.h"
#include "physics/broad_phase/swept_cells.h"
#include "physics/swept/paths.h"

namespace carom {

/// The broad phase of the solver `swept`: which bodies a ball could meet in the rest of a substep.
///
/// When the substep begins, discs around the paths are compared in a grid (NeighbourList), which
/// gives all pairs at once. A ball that changes its path leaves that grid and enters the cells that
/// its new path touches (SweptCells): so a search looks for unchanged balls in the grid and for
/// changed ones in the cells. Once many have changed, as in a pile, all enter the cells, and one
/// search is enough. Edges are in the same cells, or on a map where few balls are among many edges.
/// Kinematic edges are in neither.
class SweptCandidates {
  public:
    /// Where a search takes place: around the rest of a ball's path.
    struct Place {
        Box box;
        SweptCells::Range cells;
    };

    SweptCandidates(const SweptSubstep& step, const SweptPaths& paths)
        : step_(step), paths_(paths) {}

    /// Begins a substep: all paths are new.
    void find(const World& world);
    /// Pairs of balls, and of balls and edges, that could meet in the whole substep, in ascending
    /// order.
    std::span<const BallPair> ball_pairs() const { return neighbours_.pairs(); }
    std::span<const EdgePair> edge_pairs() const { return neighbours_.edges(); }
    /// On a torus: the periodic image index of the ball's path, relative to the disc that stands
    /// for it in these pairs. Edges of its pairs are shifted by as much.
    Vec2 image_offset(const World& world, std::uint32_t ball) const;

    /// The ball has changed its path, for the first time in this substep or again.
    void note_change(const World& world, std::uint32_t ball, double now, bool is_first);
    /// Lets all balls enter the cells if a quarter of the paths have changed.
    void merge_if_many_changed(const World& world);

    Place place_of(const World& world, std::uint32_t ball, double now) const {
        const Box box = paths_.bounding_box(world, ball, now);
        return {box, cells_.range_of(box)};
    }
    /// Calls visit(other) for each ball that could meet `ball`, perhaps including itself.
    template <typename Visit>
    void for_each_ball(const World& world, std::uint32_t ball, double now, const Place& place,
                       Visit&& visit) {
        if (!are_all_in_cells_) {
            const Disc disc = paths_.bounding_disc(world, ball, now);
            neighbours_.grid().for_each_near(disc.center, disc.radius, [&](std::uint32_t other) {
                if (paths_[other].version == 0) visit(other);
            });
        }
        cells_.for_each_in(place.cells, visit);
    }
    /// Calls visit(capsule, shift) for each edge that could be met there, some more than once;
    /// `shift` leads to its image on a torus. Kinematic edges are left out.
    template <typename Visit>
    void for_each_edge(const Place& place, Visit&& visit) {
        if (neighbours_.has_map()) {
            neighbours_.map().for_each_near(place.box,
                                            [&](std::uint32_t capsule) { visit(capsule, Vec2{}); });
            return;
        }
        cells_.for_each_cell(place.cells, [&](std::uint32_t cell, int across, int along) {
            if (edges_.is_empty(cell)) return;
            for (const CapsuleEntry entry : edges_.in_cell(cell))
                visit(entry.index, Vec2{(entry.across + across) * step_.torus.x,
                                        (entry.along + along) * step_.torus.y});
        });
    }

    /// To hide cache misses, call these some events before a search around `place`, in this order.
    /// All know the finest level of the grid only. They take a quarter off the time of a gas of
    /// 100,000 balls.
    void prefetch_cells(std::uint32_t ball, Vec2 place) const { cells_.fetch(ball, place); }
    void prefetch_starts(Vec2 place) const { neighbours_.grid().fetch_starts(place); }
    void prefetch_entries(Vec2 place) const { neighbours_.grid().fetch_places(place); }
    void prefetch_paths(Vec2 place) const;

    /// The cells of the smallest discs.
    const CellFrame& frame() const { return neighbours_.grid().finest(); }

  private:
    const SweptSubstep& step_;
    const SweptPaths& paths_;
    // Discs around the paths at the start of the substep; on a torus, the image that lies in it.
    std::vector<Vec2> centers_;
    std::vector<double> reaches_;
    NeighbourList neighbours_;
    SweptCells cells_;    // of balls that have changed their paths, or of all
    CapsuleCells edges_;  // in the same cells
    std::size_t changed_paths_ = 0;
    bool are_all_in_cells_ = false;
};

}  // namespace carom
