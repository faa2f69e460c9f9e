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

    std::uint32_t a = 0;           ///< index of a ball
    std::uint32_t b = 0;           ///< a ball of higher index; for an edge the number of balls
    std::uint32_t edge = no_edge;  ///< index of the capsule
    std::int8_t across = 0;        ///< periodic image index of the capsule on a torus
    std::int8_t along = 0;
};

/// The regions of the balls, by index. The centre is inside the torus, if there is one; the radius
/// is that of the ball, plus how far its centre may go.
struct Regions {
    std::span<const Vec2> center;
    std::span<const double> margin;  ///< how far the ball's centre may go
};

class NearPairs {
  public:
    /// Finds all pairs. Kinds that do not meet (Model::filtered) are left out, and so are held
    /// capsules. Which pairs there are depends on the regions alone; their order is arbitrary, but
    /// a function of the world and the regions.
    void find(const World& world, const Regions& regions);
    /// Finds all pairs of regions that are centred where the balls are.
    void find(const World& world, std::span<const double> margin) {
        find(world, {world.balls().position, margin});
    }

    /// The balls of `moved` (indices, each once) have new regions since the last call. `pairs()` is
    /// then just the pairs that have one of these balls. Cost: O(1) for each ball that has moved
    /// since `find`; that of `find` if these are more than half of all, or if a region is larger
    /// than all were then. Pre: apart from the motion of balls, the world is that of the last
    /// `find`, and no torus.
    void find_moved(const World& world, const Regions& regions,
                    std::span<const std::uint32_t> moved);

    std::span<const NearPair> pairs() const { return pairs_; }
    /// Indices of the balls, cell by cell, as of the last `find`: balls that are near in it are
    /// mostly near in the plane.
    std::span<const std::uint32_t> order() const { return placed_.ball; }
    const CellFrame& frame() const { return frame_; }

  private:
    /// Balls in the order of some cells.
    struct Placed {
        std::vector<std::uint32_t> ball;
        std::vector<Vec2> center;
        std::vector<double> reach;         ///< radius of the region
        std::vector<std::uint32_t> start;  ///< by cell: its first place
    };
    /// Cells of one size. Regions in it have at most half the side of a cell.
    struct Level {
        CellFrame frame;
        double reach = 0.0;       ///< largest radius of a region
        std::uint32_t first = 0;  ///< its first cell among all
        std::uint32_t begin = 0;  ///< its balls' places in the order
        std::uint32_t end = 0;
        CapsuleCells edges;
    };

    void sort_into_levels(const World& world, const Regions& regions);
    void sort_into_cells(const World& world, const Regions& regions);
    void pair_within(const World& world, const Level& level);
    void pair_with_coarser(const World& world, const Level& level, const Level& coarser);
    void pair_with_edges(const World& world, Level& level);
    void pair_with_edge(const World& world, std::uint32_t ball, Vec2 center, double reach,
                        const CapsuleEntry& entry);
    template <typename Note>
    void touching(const Placed& placed, Vec2 center, double reach, std::uint32_t first,
                  std::uint32_t last, Note&& note);
    void consider(const World& world, std::uint32_t place, std::uint32_t first, std::uint32_t last);
    void note(const World& world, std::uint32_t first, std::uint32_t second);
    bool is_cheaper_anew(const World& world, const Regions& regions,
                         std::span<const std::uint32_t> moved) const;
    void take_out(std::span<const std::uint32_t> moved);
    void sort_loose(const World& world, const Regions& regions);
    void pair_moved(const World& world, std::uint32_t ball, Vec2 center, double reach);
    void pair_moved_within(const World& world, std::uint32_t ball, Vec2 center, double reach,
                           const Placed& placed, const CellFrame& frame, std::uint32_t first_cell,
                           double largest);

    std::vector<Level> levels_;  // from fine to coarse; only the first used_ count
    std::size_t used_ = 0;
    std::vector<std::uint8_t> level_;  // by ball
    std::vector<std::uint32_t> cell_;  // by ball, among all cells of all levels
    Placed placed_;
    // Balls that have moved since `find`, in cells of their own.
    std::vector<std::uint32_t> place_;     // by ball: in placed_
    std::vector<std::uint32_t> loose_;     // balls
    std::vector<std::uint8_t> is_loose_;   // by ball
    std::vector<std::uint8_t> has_moved_;  // by ball: in this call
    Placed placed_loose_;
    double largest_loose_ = 0.0;
    std::vector<std::uint32_t> touching_;
    std::vector<NearPair> pairs_;
    Vec2 torus_;
    bool wraps_ = false;
    bool filtered_ = false;
    CellFrame frame_;
};

}  // namespace carom
