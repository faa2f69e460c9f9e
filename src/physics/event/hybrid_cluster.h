#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/broad_phase/near_pairs.h"
#include "physics/tick/disjoint_sets.h"
#include "physics/world/contact.h"
#include "physics/world/ids.h"
#include "physics/world/world.h"

namespace carom {

/// The cluster of a hybrid step (hybrid_step.h): the balls and held bodies that `contact` steps in
/// this tick. It depends on the world alone, and not on the order of balls.
///
/// A ball is *dense* if it has had more than `dense_collisions` collisions in quick succession, the
/// last of them with another ball, in a scene with gravity that loses energy (`loses_energy`). It
/// is *sunk* if impacts have not opened a deep overlap (CollapseGuard::note_sunk).
/// EventMemory::clustered names the balls that are dense or sunk at the end of a tick, and those
/// that have not yet returned (below).
///
/// *The cluster* of a tick: the balls of EventMemory::clustered, all balls that could meet one of
/// them within the tick, all that could meet those, and so on. A ball's *reach* is the furthest
/// that it is assumed to get: what its speed and twice a fall from rest give. A held body belongs
/// to the cluster if it could meet a ball of the cluster; then so do all balls that it could meet.
///
/// An impact can take a ball further than its reach. The reach then becomes twice the distance that
/// the ball went (`widen`), and the cluster is found again.
///
/// *Seesaws.* A ball that has met a seesaw in quick succession is dense too; it stays in the
/// cluster while something presses it on the seesaw. A seesaw counts as reaching all round its
/// hinge.
///
/// *Return.* After the tick a ball stays in EventMemory::clustered while something presses it on
/// another ball, and while it overlaps a ball or an edge by more than `most_overlap` of its radius.
/// All other balls start exact trajectories. A ball that touches the cluster belongs to it again in
/// the next tick.
///
/// *Hands.* What a hand lifts belongs to the cluster, dense or not: under `event` a pile on a
/// moving plate would hop without end. While hands push in other directions, and the world has at
/// most `most_pushed` balls, there are no clusters, since `event` lets nothing overlap.
class HybridCluster {
  public:
    /// Whether the next tick needs a hybrid step. Pre: uses_hybrid_step (physics/solver.h).
    static bool is_needed(const World& world);

    static constexpr double most_overlap = 1e-5;
    static constexpr std::size_t most_pushed = 64;

    /// Finds the cluster of the next tick, as far as it is known before its impacts.
    void find(const World& world);
    /// Widens the reach of a ball that was at `place` during the tick, if that is beyond its reach.
    /// Returns whether it was. Pre: `find` was called for this world.
    bool widen(const World& world, std::uint32_t ball, Vec2 place);
    /// Finds the cluster again, with the widened reaches. Returns whether it has changed.
    bool find_again(const World& world);

    bool has_ball(std::size_t ball) const { return is_clustered_[ball] != 0; }
    /// By index into World::held_capsules.
    bool has_held_capsule(std::size_t held) const { return has_ball(ball_count_ + held); }
    bool has_balls() const;
    bool is_everything() const;

    /// The balls that stay in EventMemory::clustered. `cluster` is a world of the balls of the
    /// cluster at the end of the tick. Ascending.
    void find_staying(const World& cluster, std::vector<BallId>& staying);

  private:
    void find_reach(const World& world);
    void unite_and_mark(const World& world);
    void unite_held_capsules(const World& world);
    static std::optional<std::uint32_t> node_of(const World& world, const Hand& hand);

    NearPairs near_;
    std::vector<double> reach_;               // by ball, length
    DisjointSets sets_;                       // balls, then held capsules
    std::vector<std::uint8_t> is_clustered_;  // by ball, then by World::held_capsules
    std::vector<std::uint8_t> was_clustered_;
    std::size_t ball_count_ = 0;
    std::vector<std::uint8_t> stays_;  // find_staying: by ball of the cluster
    std::vector<double> margin_;
};

}  // namespace carom
