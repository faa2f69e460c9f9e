#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/near_edges.h"

namespace carom {

/// A Verlet neighbour list: pairs of balls, and of balls and edges, that are near one another. It
/// stays valid until a ball has gone further than the margin from where it was when the list was
/// built (its reference position), so that several steps, and often several ticks, share one list.
///
/// Callers must filter pairs by collision rules and skip held balls. The list has no held capsules.
/// Distances are from surface to surface.
class NeighbourList {
  public:
    /// Lists all pairs of balls that are nearer to one another than twice `margin`, and all balls
    /// that are nearer to an edge than `edge_margin`. Pre: margin >= 0.
    void build(const World& world, double margin);
    /// Lists pairs of discs in place of the balls, such as discs around their paths: by ball, with
    /// these centres and radii. The margin is 0.
    void build(const World& world, std::span<const Vec2> centers, std::span<const double> radii);

    /// Whether every two bodies that overlap now are in the list: the balls and edges are the same,
    /// and no ball has gone further than the margin. With margin 0: false.
    bool is_valid(const World& world);
    /// Whether the list is still valid if no ball has moved further than `displacement` since its
    /// place was last noted, by `is_valid` or `note_place`. A bound, which does not read the world.
    bool is_valid_after(double displacement);
    /// Whether the list has all neighbours of one ball, which is now at `position`.
    bool is_valid_for(std::uint32_t ball, Vec2 position) const;
    /// Notes where a ball is for `is_valid_after`, and tells what `is_valid_for` does.
    bool note_place(std::uint32_t ball, Vec2 position);

    /// A quarter of the radius, or the margin if that is more: what is pushed in a step seldom
    /// goes further. For discs that stand for the balls 0.
    double edge_margin(double radius) const { return edge_margin_.of(radius); }
    /// In the order of the cells, in which neighbours in the list are near in memory too.
    std::span<const BallPair> pairs() const { return pairs_; }
    /// Puts `pairs` in ascending order.
    void sort_pairs() { order_.sort(pairs_, balls_); }
    /// In ascending order.
    std::span<const EdgePair> edges() const { return near_edges_.all(); }

    void list_by_ball() {
        if (adjacency_.is_empty()) adjacency_.build(pairs_, balls_);
    }
    /// The balls in pairs with `ball`, in no order. Pre: `list_by_ball` since the last `build`.
    std::span<const std::uint32_t> of(std::uint32_t ball) const { return adjacency_.of(ball); }
    std::span<const EdgePair> edges_of(std::uint32_t ball) const { return near_edges_.of(ball); }

    /// Calls visit(pair) for the edges that a ball may touch that is now at `position`, whether the
    /// list is valid for it or not; perhaps for some that it does not.
    template <typename Visit>
    void for_each_edge_at(std::uint32_t ball, Vec2 position, Visit&& visit) const {
        near_edges_.for_each_at(grid_, ball, position, visit);
    }

    const DiscGrid& grid() const { return grid_; }

    /// Few balls are among many edges: these are on a map, and not in the cells of the grid. Only
    /// where discs stand for the balls.
    bool has_map() const { return near_edges_.has_map(); }
    /// Pre: has_map().
    EdgeMap& map() { return near_edges_.map(); }

  private:
    /// What a list depends on besides where the balls are.
    struct Scene {
        std::vector<double> radius;   ///< of the balls
        std::vector<Capsule> shapes;  ///< of the capsules
        Stamp capsules{};             ///< when these were so
        std::vector<CapsuleId> held;  ///< left out
        bool has_ball_pairs = false;
        bool has_edge_pairs = false;

        void note(const World& world);
        bool is_of(const World& world) const;
    };

    void build_around(const World& world, std::span<const Vec2> centers,
                      std::span<const double> radii, bool uses_map);
    double squared_displacement(std::uint32_t ball, Vec2 position) const;
    // The square of the margin, less a bound of rounding.
    double room() const { return 0.999 * margin_ * (0.999 * margin_); }

    double margin_ = 0.0;
    EdgeMargin edge_margin_;
    double furthest_ = 0.0;  // square of what no ball has gone beyond since the list was built
    Vec2 torus_;
    DiscGrid grid_;
    NearEdges near_edges_;
    std::vector<Vec2> reference_;  // by ball; empty with margin 0
    Scene scene_;                  // where margin > 0
    std::size_t balls_ = 0;
    std::vector<BallPair> pairs_;
    PairOrder order_;
    BallAdjacency adjacency_;
};

}  // namespace carom
