#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/kinematic_bodies.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/event/motion/trajectories.h"
#include "physics/event/motion/work_meter.h"
#include "physics/event/rest/cloth_phases.h"
#include "physics/event/rest/collapse_guard.h"
#include "physics/event/rest/resting_contact.h"
#include "physics/event/uniform_motion.h"
#include "physics/world/world.h"

namespace carom {

/// What the solver takes from the world when a tick begins, and what it leaves there when it ends.
///
/// A tick begins in one of three ways:
/// - *continued*, if the world is as the last tick left it: trajectories, cells and queue stay.
/// - *changed*, if only Stamps::motion differs, because the stop speed or the speed limit changed
///   velocities at the end of the last tick. Those balls start new trajectories (`apply_changes`).
/// - *rebuilt* otherwise: after any edit that gives a stamp other than `motion` alone
///   (world/README.md); if anything is held in this tick or was in the last; at another tick
///   number; with one-way edges (in every tick); if more than n/8 + 1 balls of n have changed; and
///   if the grid no longer fits the balls (checked every 64 ticks).
///
/// The world stores the trajectories, so that a copy of it continues with the same bits. A rebuild
/// keeps every stored trajectory that leads, bit by bit, through the position and velocity that the
/// world shows, whose supports are in place, and which no edge has been put across since.
template <typename Real>
class WorldSync {
  public:
    enum class Begun : std::uint8_t {
        continued,  ///< nothing has changed
        changed,    ///< `changed()` have new trajectories, to be predicted
        rebuilt,    ///< everything has to be predicted
    };

    struct Parts {
        const EventScene<Real>& scene;
        BallTable<Real>& balls;
        SpatialIndex<Real>& space;
        Trajectories<Real>& trajectories;
        KinematicBodies<Real>& kinematic;
        RestingContact<Real>& rest;
        const ClothPhases<Real>& cloth;
        CollapseGuard<Real>& guard;
        const UniformMotion<Real>& uniform;
        ToiSearch<Real>& search;
        std::vector<std::uint32_t>& scatter_counts;
    };
    explicit WorldSync(const Parts& parts);

    /// Takes the scene's world. The state of the last tick is void from now until `write`.
    Begun begin();
    const std::vector<std::uint32_t>& changed() const { return changed_; }

    /// Writes the state at the end of the tick. `has_stopped`: time stood still from some event on,
    /// so that all trajectories are new, and the next tick rebuilds.
    void write(World& world, bool has_stopped);

  private:
    /// What the last tick left in the world, to tell whether anybody has changed it since.
    struct LastWritten {
        bool is_valid = false;
        std::uint64_t tick = 0;
        Stamps stamps;
        // For other numbers than doubles, whose trajectories are not in the world:
        Model model;
        std::vector<BallId> ids;
        std::vector<std::uint32_t> support_digests;  ///< by ball (StoredCurvedPart)
    };
    /// Position and velocity as the world shows them.
    struct Shown {
        Vec2 position;
        Vec2 velocity;
    };

    // world_begin.cpp
    Begun begin_from(const World& world);
    void apply_changes(const World& world);
    void note_collisions();
    void rebuild(const World& world);
    void take_stored(const World& world, const BallTable<Real>& before);
    void take_spins(const World& world);
    void drop_unsupported();
    void start_or_shift(const World& world, std::uint32_t ball);
    // retained.cpp: which stored trajectories still hold
    bool leads_through(const Trajectory<Real>& trajectory, std::size_t ball) const;
    bool are_supports_unchanged(const Trajectory<Real>& trajectory, std::uint32_t digest) const;
    bool has_support(std::size_t ball) const;
    bool has_passed_an_edge(std::uint32_t ball);
    // world_sync.cpp
    bool is_continued(const World& world) const;
    Shown shown(std::size_t ball, const Real& time) const;
    bool is_position_unchanged(std::uint32_t ball) const;
    bool is_velocity_unchanged(std::uint32_t ball) const;
    bool is_spin_unchanged(std::uint32_t ball) const;
    bool is_roll_unchanged(std::uint32_t ball) const;
    bool is_rotation_unchanged(std::uint32_t ball) const {
        return is_spin_unchanged(ball) && is_roll_unchanged(ball);
    }
    bool has_lain_still(std::uint32_t ball) const;
    bool has_kept_spin(std::uint32_t ball) const;
    bool writes_lines() const {
        return trajectories_.are_all_straight() && !scene_.world->model().speed_limit;
    }
    void write_lines(World& world);
    void write_begun(World& world, std::span<const std::uint32_t> begun);
    void write_states(World& world);
    bool limit_speeds(World& world) const;
    void clear_stored(World& world);
    void store_trajectories(World& world);
    void write_spins(World& world);
    void write_rolls(World& world) const;
    void write_dense(World& world);

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    SpatialIndex<Real>& space_;
    Trajectories<Real>& trajectories_;
    KinematicBodies<Real>& kinematic_;
    RestingContact<Real>& rest_;
    const ClothPhases<Real>& cloth_;
    CollapseGuard<Real>& guard_;
    const UniformMotion<Real>& uniform_;
    ToiSearch<Real>& search_;
    std::vector<std::uint32_t>& scatter_counts_;
    LastWritten last_written_;
    Real began_{};  ///< s: the time at which the tick began
    bool is_rebuilt_ = false;
    bool is_unchanged_ = false;  ///< nobody has moved or pushed a ball since the last tick
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint32_t> collisions_;  ///< by ball: CollapseGuard::remaining
    std::vector<std::uint32_t> moving_;      ///< balls that `write_states` has written
    std::vector<std::uint8_t> is_kept_;      ///< by ball: its stored trajectory holds
    std::vector<std::int64_t> spin_from_;    ///< by ball: index of its stored spin; -1: none
};

}  // namespace carom
