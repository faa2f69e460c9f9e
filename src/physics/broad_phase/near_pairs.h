#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/cell_frame.h"
#include "physics/world/world.h"

/// Which bodies could touch while each ball stays in its region, a disc around a reference
/// position: the broad phase of the solver `contact`, and of the clusters of `event`. README.md
/// says why it is not a DiscGrid.
///
/// Regions within a factor of two of one another share a *level* of cells. A ball is compared with
/// its own level and with all coarser ones, so a few large balls among many small ones cost little.
namespace carom {

/// A ball and another ball, or an edge, that could touch.
struct NearPair {
    static constexpr std::uint32_t no_edge = 0xffffffffu;

    std::uint32_t a = 0;           ///< a body: by place in the order of NearPairs::sort
    std::uint32_t b = 0;           ///< another body; for an edge the number of balls
    std::uint32_t edge = no_edge;  ///< index of the capsule
    std::int8_t across = 0;        ///< periodic image index of the capsule on a torus
    std::int8_t along = 0;
};

/// The regions of the balls, in the order of NearPairs::sort.
struct Regions {
    std::span<const std::uint32_t> ball;  ///< index in the world
    std::span<const Vec2> center;
    std::span<const double> radius;  ///< of the ball
    std::span<const double> margin;  ///< how far its centre may go
};

class NearPairs {
  public:
    /// Puts the balls' indices in the order of the cells: balls that are near in it are mostly near
    /// in the plane. By ball, `place`: the centre of its region (inside the torus, if there is
    /// one); `margin`: how far the ball's centre may go from there.
    void sort(const World& world, const std::vector<Vec2>& place, const std::vector<double>& margin,
              std::vector<std::uint32_t>& order);

    /// Finds all pairs. Kinds that do not meet (Model::filtered) are left out, and so are held
    /// capsules. Of two balls, a has the lower number. Pre: `regions` are those that `sort` was
    /// given, in its order.
    void find(const World& world, const Regions& regions);

    /// Sorts and finds, with regions around where the balls are.
    void find(const World& world, const std::vector<double>& margin,
              std::vector<std::uint32_t>& order);

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

    void sort_into_levels(const World& world, const std::vector<Vec2>& place,
                          const std::vector<double>& margin);
    void sort_into_cells(const std::vector<Vec2>& place, std::vector<std::uint32_t>& order);
    void pair_within(const World& world, const Regions& regions, const Level& level);
    void pair_with_coarser(const World& world, const Regions& regions, const Level& level,
                           const Level& coarser);
    void pair_with_edges(const World& world, const Regions& regions, Level& level);
    void pair_with_edge(const World& world, const Regions& regions, std::uint32_t i,
                        const CapsuleEntry& entry);
    void consider(const World& world, const Regions& regions, std::uint32_t i, std::uint32_t first,
                  std::uint32_t last);
    void note(const World& world, const Regions& regions, std::uint32_t i, std::uint32_t j);

    std::vector<Level> levels_;  // from fine to coarse; only the first used_ count
    std::size_t used_ = 0;
    std::vector<std::uint8_t> level_;   // by ball
    std::vector<std::uint32_t> cell_;   // by ball, among all cells of all levels
    std::vector<std::uint32_t> start_;  // by cell: its first place in the order
    std::vector<std::uint32_t> touching_;
    std::vector<NearPair> pairs_;
    // Regions, for callers that have none.
    std::vector<Vec2> center_;
    std::vector<double> radius_;
    std::vector<double> margin_;
    Vec2 torus_;
    bool wraps_ = false;
    bool filtered_ = false;
    CellFrame frame_;
};

}  // namespace carom
