#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "physics/contact/solver.h"
#include "physics/event/engine.h"
#include "physics/event/hybrid_cluster.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

namespace carom {

/// Hybrid stepping: `contact` steps the dense clusters, in which events would never end, and
/// `event` advances everything else. hybrid_cluster.h says which balls belong to the cluster of a
/// tick, and when they return. README.md has the pre- and postconditions.
///
/// `contact` steps the cluster in a world that holds only the cluster and the edges; `event`
/// advances all other balls on their exact trajectories in a world without it. If an impact takes a
/// ball further than its reach, and that adds balls to the cluster, the tick is repeated. After
/// `most_attempts`, and where everything belongs to the cluster, `contact` steps all balls, and all
/// exact trajectories are dropped.
///
/// In the cluster the guarantees of `contact` hold: no tunnelling, elastic impacts that conserve
/// energy, a small overlap under pressure that shrinks with more substeps, and a result that
/// depends on the tick rate. Emitters, sinks and flippers act on the whole world, before and after
/// this.
class HybridStep {
  public:
    /// Substeps of `contact` in a tick: the fewest of 4, 8 and 16 in which a ball of the smallest
    /// radius falls from rest by at most `most_fall` of it, or else 16. `most_fall` x10: piles
    /// overlap more; /10: hybrid steps cost up to four times as much.
    static constexpr int least_substeps = 4;
    static constexpr int most_substeps = 16;
    static constexpr double most_fall = 1.0 / 2048.0;
    /// How often a tick is computed. More: a tick may cost as much more; fewer: exact trajectories
    /// are lost more often.
    static constexpr int most_attempts = 4;

    /// Advances by one tick a world that needs a hybrid step (HybridCluster::is_needed).
    /// Parameters: see EventEngine::tick. A cancelled tick leaves the world as it was.
    EventOutcome tick(World& world, EventEngine<double>& event, ContactSolver& contact,
                      std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched,
                      const std::function<bool()>& keep_going, bool is_repeated = false);

    /// ContactSolver::pressing of the last tick.
    std::span<const Contact> pressing() const { return pressing_; }
    /// The balls for which time stood still in a part of the last tick, by index, with repetitions.
    std::span<const std::uint32_t> standing() const { return standing_; }
    /// The same for rejected attempts, which have drawn on the work budget too.
    std::span<const std::uint32_t> standing_before() const { return standing_before_; }

  private:
    /// Some of the balls of a world, as a world of their own.
    struct Part {
        World world;
        std::vector<std::uint32_t> ball;  ///< by index in it: index in the whole
        std::vector<Contact> contacts;
        std::vector<std::uint8_t> touched;
    };

    void take_part(const World& world, bool of_cluster, Part& part) const;
    bool has_free_part_of(const World& world);
    static void name_by_whole(const Part& part, std::span<Contact> contacts);
    bool widen_reaches(const World& world, const Part& part);
    bool widen(const World& world, const Contact& contact, const Part& part);
    /// Lets `contact` step all balls.
    void step_all(World& world, ContactSolver& contact, std::vector<Contact>& contacts,
                  std::vector<std::uint8_t>& touched);
    void write_back(World& world, std::vector<std::uint8_t>& touched) const;
    void note_standing(const EventEngine<double>& event, const ContactSolver& contact,
                       std::vector<std::uint32_t>& standing) const;
    void note_pressing(const EventEngine<double>& event, const ContactSolver& contact);
    void merge_contacts(std::vector<Contact>& contacts);
    void merge_memory(World& world);
    static int substeps_for(const World& cluster);

    std::vector<std::uint32_t> standing_;
    std::vector<std::uint32_t> standing_before_;
    std::vector<Contact> pressing_;
    HybridCluster cluster_;
    Part free_;
    std::optional<Stamps> free_stamps_;  // of the world that free_ is a part of
    Part dense_;                         // the cluster
};

}  // namespace carom
