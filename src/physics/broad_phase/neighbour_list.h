#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/disc_grid.h"
#include "physics/broad_phase/edge_map.h"
#include "physics/world/world.h"

/// Who is near whom: pairs of balls, and of balls and edges.
namespace carom {

/// Two balls by index, first < second.
struct BallPair {
    std::uint32_t first = 0;
    std::uint32_t second = 0;

    friend auto operator<=>(const BallPair&, const BallPair&) = default;
};

/// A ball and an edge by index; on a torus, which image of the edge.
struct EdgePair {
    std::uint32_t ball = 0;
    std::uint32_t capsule = 0;
    std::int8_t along = 0;
    std::int8_t across = 0;

    friend auto operator<=>(const EdgePair&, const EdgePair&) = default;
};

/// Puts pairs of balls in ascending order.
class PairOrder {
  public:
    /// `balls`: how many there are. Takes as long as there are pairs.
    void sort(std::vector<BallPair>& pairs, std::size_t balls);

  private:
    std::vector<std::uint32_t> start_;
    std::vector<BallPair> sorted_;
};

/// What `look` found stays good until some ball has gone further than the margin from where it was
/// then, so that several steps can share it. Filters of who meets whom, and hands, are the caller's
/// business; held capsules are left out.
///
/// All is measured from surface to surface.
class Neighbours {
  public:
    /// Notes all pairs of balls that are nearer to one another than twice `margin`, and all balls
    /// that are nearer to an edge than `edge_margin`. Pre: margin >= 0.
    void look(const World& world, double margin);
    /// The same for discs that stand for the balls, as those around their paths do: they have these
    /// centres and radii, by ball. Margin 0.
    void look(const World& world, std::span<const Vec2> centers, std::span<const double> radii);

    /// Whether every two bodies that overlap now are among those noted: same balls, none of which
    /// has gone further than the margin, and same edges. With margin 0: false.
    bool cover(const World& world);
    /// The same without a look at the world, if it was so since the last look and no ball has gone
    /// further than `way` since it was last asked for, here or by `note_place`.
    bool cover_after(double way);
    /// The same for a single ball, which is now at `position`.
    bool covers(std::uint32_t ball, Vec2 position) const;
    /// The same, for `cover_after` to know where the ball is.
    bool note_place(std::uint32_t ball, Vec2 position);

    /// A quarter of the radius, or the margin if that is more: what is pushed in a step seldom
    /// goes further. For discs that stand for the balls 0.
    double edge_margin(double radius) const { return std::max(margin_, push_ * radius); }
    /// In the order of the cells, in which what follows one another is near in memory too.
    std::span<const BallPair> pairs() const { return pairs_; }
    /// Puts `pairs` in ascending order.
    void sort_pairs() { order_.sort(pairs_, balls_); }
    /// In ascending order.
    std::span<const EdgePair> edges() const { return edges_; }

    /// The balls in pairs with `ball`, in no order. Pre: `list_by_ball` since the last `look`.
    std::span<const std::uint32_t> of(std::uint32_t ball) const {
        return std::span(others_).subspan(others_start_[ball],
                                          others_start_[ball + 1] - others_start_[ball]);
    }
    void list_by_ball();
    std::span<const EdgePair> edges_of(std::uint32_t ball) const;

    /// Calls visit(capsule, across, along) for the edges that a ball may touch that is now at
    /// `position`, covered or not; perhaps for some that it does not.
    template <typename Visit>
    void for_each_edge_at(std::uint32_t ball, Vec2 position, Visit&& visit) const {
        if (cells_of_edges_.empty()) return;
        const std::size_t level = grid_.level_of(ball);
        const CellFrame& frame = grid_.frame(level);
        const std::uint32_t cell = frame.index(frame.column(position.x), frame.row(position.y));
        for (const CapsuleEntry entry : cells_of_edges_[level].in_cell(cell))
            visit(EdgePair{ball, entry.index, entry.along, entry.across});
    }

    const DiscGrid& grid() const { return grid_; }

    /// Few balls are among many edges: these are on a map, and not in the cells of the grid. Only
    /// where discs stand for the balls.
    bool has_map() const { return has_map_; }
    /// Pre: has_map().
    EdgeMap& map() { return map_; }

  private:
    void note(const World& world, std::span<const Vec2> centers, std::span<const double> radii);
    void note_scene(const World& world);
    bool is_scene_of(const World& world) const;
    double gone(std::uint32_t ball, Vec2 position) const;
    // The square of the margin, without what is for rounding.
    double room() const { return 0.999 * margin_ * (0.999 * margin_); }
    void look_for_edges(const World& world, std::span<const Vec2> centers,
                        std::span<const double> radii);
    void look_in_cells(const World& world, std::span<const Vec2> centers,
                       std::span<const double> radii);
    void look_on_map(const World& world, std::span<const Vec2> centers,
                     std::span<const double> radii);

    double margin_ = 0.0;
    double push_ = 0.0;      // share of the radius
    double furthest_ = 0.0;  // square of what no ball has gone beyond since the look
    Vec2 torus_;
    DiscGrid grid_;
    std::vector<CapsuleCells> cells_of_edges_;  // by level
    bool has_map_ = false;
    EdgeMap map_;
    std::vector<Vec2> reference_;  // where the balls were; empty with margin 0
    std::vector<double> radius_;   // the same
    std::vector<Capsule> shapes_;  // the same, of the capsules
    Stamp stamp_{};                // of them
    std::vector<CapsuleId> held_;  // the same: in hands, and left out
    bool meet_balls_ = false;
    bool meet_edges_ = false;
    std::size_t balls_ = 0;
    std::vector<BallPair> pairs_;
    PairOrder order_;
    std::vector<EdgePair> edges_;
    std::vector<std::uint8_t> has_edges_;  // by ball
    std::vector<std::uint32_t> others_start_;
    std::vector<std::uint32_t> others_;
};

/// Whether `disc` overlaps the edge of the pair, whatever its ball.
bool overlaps_edge(const World& world, const EdgePair& pair, const Disc& disc);

}  // namespace carom
