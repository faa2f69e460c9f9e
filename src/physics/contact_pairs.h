#pragma once

#include <cstdint>
#include <vector>

#include "physics/capsule_cells.h"
#include "physics/cell_frame.h"
#include "physics/world.h"

/// The broad phase of the solver `contact`: which bodies could touch while each stays in a region
/// of its own, a disc around the place where it is now.
///
/// Cells suit regions of one size. Where sizes differ there is a level of cells for each factor of
/// two, and a ball looks for others in its own level and in all coarser ones; so a few large balls
/// among many small ones cost little.
namespace carom {

/// A ball and another ball, or an edge, that could touch.
struct NearPair {
    static constexpr std::uint32_t no_edge = 0xffffffffu;

    std::uint32_t a = 0;           ///< by place in NearPairs::order
    std::uint32_t b = 0;           ///< the same; for an edge the number of balls
    std::uint32_t edge = no_edge;  ///< index of the capsule
    std::int8_t across = 0;        ///< which image of the capsule on a torus
    std::int8_t along = 0;
};

class NearPairs {
  public:
    /// Finds all pairs. `margin`: by ball, how far its centre may go. Who does not meet whom
    /// (Model::filtered) is left out, and so are held capsules. Ball on ball, a has the lower
    /// number.
    void find(const World& world, const std::vector<double>& margin);

    /// The balls' indices cell by cell: near in this order is mostly near in the plane.
    const std::vector<std::uint32_t>& order() const { return order_; }
    const std::vector<NearPair>& pairs() const { return pairs_; }
    std::vector<NearPair>& pairs() { return pairs_; }
    const CellFrame& frame() const { return frame_; }

  private:
    /// Cells of one size. Regions in it have at most half the side of a cell.
    struct Level {
        CellFrame frame;
        double reach = 0.0;       ///< largest radius of a region
        std::uint32_t first = 0;  ///< its first cell among all
        std::uint32_t begin = 0;  ///< its balls' places in the order
        std::uint32_t end = 0;
        CapsuleCells edges;
    };

    void sort_into_levels(const World& world, const std::vector<double>& margin);
    void sort_into_cells(const World& world);
    void pair_within(const World& world, const Level& level);
    void pair_with_coarser(const World& world, const Level& level, const Level& coarser);
    void pair_with_edges(const World& world, Level& level);
    void consider(const World& world, std::uint32_t i, std::uint32_t j);
    bool is_near(std::uint32_t i, std::uint32_t j) const;

    std::vector<Level> levels_;  // from fine to coarse; only the first used_ count
    std::size_t used_ = 0;
    std::vector<std::uint8_t> level_;  // by ball
    std::vector<std::uint32_t> cell_;  // by ball, among all cells of all levels
    std::vector<std::uint32_t> start_;
    std::vector<std::uint32_t> fill_;
    std::vector<double> reach_;  // by ball: radius + margin
    std::vector<std::uint32_t> order_;
    std::vector<Vec2> place_;     // by place in the order
    std::vector<double> around_;  // the same: reach
    std::vector<NearPair> pairs_;
    Vec2 torus_;
    bool wraps_ = false;
    bool filtered_ = false;
    CellFrame frame_;
};

}  // namespace carom
