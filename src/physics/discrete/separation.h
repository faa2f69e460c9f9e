#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/discrete/motion.h"
#include "physics/discrete/shared_neighbours.h"

namespace carom {

/// How the solvers `discrete` and `substep` separate bodies that overlap once all have moved:
/// balls, each pair once, by half of the depth each; then balls are pushed out of edges.
///
/// Which balls overlap is decided before any is pushed, and which overlap edges when the balls are
/// separated; pairs go by the numbers of their balls. So the result depends on positions and
/// numbers, not on cells. A held ball does not give way to balls; edges stop it.
class OverlapSeparation {
  public:
    OverlapSeparation(const OverlapStep& step, const OverlapKinematics& kinematics,
                      const OverlapMotion& motion, SharedNeighbours& neighbours)
        : step_(step), kinematics_(kinematics), motion_(motion), neighbours_(neighbours) {}

    void begin_tick(const World& world) { is_pushed_.resize(world.balls().size(), 0); }
    /// Pre: the neighbour list holds.
    void separate(World& world);
    /// The pairs that were separated in this step, and the balls that were pushed.
    std::span<const OverlapPair> pairs() const { return pairs_; }
    std::span<const PushedBall> pushed() const { return pushed_; }
    void end_step();

  private:
    template <Terms terms>
    void separate_active(World& world);
    template <Terms terms>
    void separate_overlapping(World& world, std::span<const BallPair> pairs);
    template <Terms terms>
    void separate_pair(World& world, std::uint32_t i, std::uint32_t j);
    template <Terms terms>
    void push_out_of_edges(World& world);
    void note_edge(const World& world, const EdgePair& pair);
    void find_edges_of_moved_balls(const World& world);
    void find_kinematic_edges(const World& world);
    template <Terms terms>
    void push_out_of_edge(World& world, const EdgePair& pair);
    void note_push(const World& world, std::uint32_t ball);

    const OverlapStep& step_;
    const OverlapKinematics& kinematics_;
    const OverlapMotion& motion_;
    SharedNeighbours& neighbours_;
    std::vector<OverlapPair> pairs_;
    std::vector<PushedBall> pushed_;
    std::vector<std::uint8_t> is_pushed_;  // by ball: 0, 1, or `beyond_margin`
    // Scratch.
    std::vector<BallPair> near_active_;
    std::vector<BallPair> overlapping_;
    PairOrder order_;
    std::vector<EdgePair> at_edge_;
};

}  // namespace carom
