#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "physics/broad_phase/near_pairs.h"
#include "physics/contact/solver.h"
#include "physics/event/engine.h"
#include "physics/event/motion/event_memory.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

namespace carom {

/// Hybrid stepping: dense clusters, in which events would never end, are stepped by `contact`, and
/// everything else by `event`. The rule depends on the world alone, and not on the order of balls.
///
/// *Dense* is a ball with more than `dense_collisions` collisions in quick succession, the last of
/// them with another ball, where gravity acts and impacts lose energy. EventMemory::clustered names
/// the dense balls at the end of a tick.
///
/// *The cluster* of a tick: the balls of EventMemory::clustered, all that could meet one of them
/// within the tick, all that could meet those, and so on. A ball is assumed to get as far as its
/// speed and twice a fall from rest take it: its *reach*. A held body belongs to the cluster if it
/// could meet a ball of it; then so do all balls that it could meet.
///
/// *The tick.* `contact` steps the cluster in a world that holds only it and the edges; `event`
/// advances the others on their exact trajectories in a world without it. An impact can make a ball
/// faster than its reach allows: then its reach becomes twice the distance that it got. If that
/// adds balls to the cluster, the tick is repeated; after `most_attempts`, `contact` steps all, and
/// all exact trajectories are forgotten.
///
/// *Coming back.* After the tick a ball stays in EventMemory::clustered while something presses it
/// on another ball, and while it overlaps a ball or an edge by more than `sunk` of its radius. All
/// others start exact trajectories; those that touch the cluster belong to it again in the next
/// tick.
///
/// In the cluster the guarantees of `contact` hold: no tunnelling, energy of elastic impacts, a
/// small overlap under pressure that shrinks with more substeps, and a result that depends on the
/// tick rate. Emitters, sinks and flippers act once, on the whole world, outside of this.
///
/// *Hands.* What a hand lifts belongs to the cluster, dense or not: in events a pile on a moving
/// plate hops without end. While hands push in other directions, and the world has at most
/// `most_pushed` balls, there are no clusters: events let nothing overlap.
class HybridStep {
  public:
    /// Whether the next tick needs a hybrid step. Pre: the model has gravity, losses and collisions
    /// of balls.
    static bool is_needed(const World& world);

    /// The cluster of the next tick, as far as it is known before its impacts. Ascending.
    const std::vector<BallId>& cluster_of(const World& world);

    /// Substeps of `contact` in a tick: the fewest of 4, 8 and 16 in which a ball of the smallest
    /// radius falls from rest by at most `most_fall` of it, or else 16.
    static constexpr int least_substeps = 4;
    static constexpr int most_substeps = 16;
    static constexpr double most_fall = 1.0 / 2048.0;
    static constexpr int most_attempts = 4;
    static constexpr double sunk = 1e-5;
    static constexpr std::size_t most_pushed = 64;

    /// A tick of a world whose EventMemory::clustered is not empty. As EventEngine::tick; a tick
    /// that is cancelled leaves the world as it was.
    EventOutcome tick(World& world, EventEngine<double>& event, ContactSolver& contact,
                      std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched,
                      const std::function<bool()>& keep_going);

    /// The balls for which time stood still in a part of the last tick, by index, with repetitions.
    std::span<const std::uint32_t> standing() const { return standing_; }

  private:
    /// Some of the balls of a world, as a world of their own.
    struct Part {
        World world;
        std::vector<std::uint32_t> ball;  ///< by index in it: index in the whole
        std::vector<Contact> contacts;
        std::vector<std::uint8_t> touched;
    };

    void find_reach(const World& world);
    void find_cluster(const World& world);
    bool has_clustered_ball(const World& world) const;
    void unite_held_capsules(const World& world);
    static std::optional<std::uint32_t> node_of(const World& world, const Hand& hand);
    std::uint32_t root_of(std::uint32_t node);
    void unite(std::uint32_t a, std::uint32_t b);
    void take_part(const World& world, bool of_cluster, Part& part) const;
    bool has_free_part_of(const World& world);
    bool widen_reaches(const World& world, const Part& part);
    bool widen(const World& world, const Contact& contact, const Part& part);
    bool widen_to(const World& world, std::uint32_t ball, Vec2 place);
    void write_back(World& world, const Part& part, std::vector<std::uint8_t>& touched) const;
    void merge_contacts(std::vector<Contact>& contacts);
    static int substeps_for(const World& cluster);
    void find_staying(const World& cluster, std::vector<BallId>& staying);

    std::vector<std::uint32_t> standing_;
    NearPairs near_;
    std::vector<std::uint32_t> order_;        // of the balls in near_
    std::vector<double> reach_;               // by ball, length
    std::vector<std::uint32_t> parent_;       // union-find: balls, then held capsules
    std::vector<std::uint8_t> is_clustered_;  // by ball, then by World::held_capsules
    std::vector<std::uint8_t> was_clustered_;
    std::vector<std::uint8_t> stays_;
    std::vector<double> margin_;
    std::vector<BallId> ids_;  // result of cluster_of
    Part free_;
    std::optional<Stamps> free_stamps_;  // of the world that free_ is a part of
    Part cluster_;
};

}  // namespace carom
