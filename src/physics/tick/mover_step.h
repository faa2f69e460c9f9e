#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/tick/disjoint_sets.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Movers (world/mover.h): how far edges that move by themselves get in a tick.
///
/// A tick carries an edge straight from where its mover has it at the clock of the tick's start to
/// where it has it at the clock of the end. A solver therefore sees a driven edge in uniform motion
/// (HeldCapsule::is_driven), as it sees a flipper: what meets it is thrown with the velocity of the
/// edge at that place. A turning edge is on its arc at the ends of each tick, and within the tick
/// on the chords of its two ends.
///
/// A mover *yields*: it waits for a ball that it would crush. How far it gets is found by trial, as
/// for hands (hands.h). Solver::tick computes the tick with all movers at the shares of their steps
/// that they begin with. If the result is not sound, it restores the world from a copy, and movers
/// that had a part in that try half their share, down to 1/64, and then 0. The next tick starts
/// from twice the last share, at most 1. A mover's clock goes on by its share of the tick.
///
/// Cost: nothing in a world without movers, or while none of them runs. Else a copy of the world in
/// each tick, and work that grows with the contacts of the tick.
namespace carom {

/// Moves the movers through a tick.
class MoverStep {
  public:
    /// Begins a tick: makes the edges of movers that run driven edges (World::held_capsules).
    /// Returns whether there are any.
    bool begin(World& world);

    /// Sets the targets in the world to where the edges are to be at the end of this trial.
    void aim(World& world) const;

    /// What a trial has given, with bodies in contacts and in `standing` by index.
    struct Trial {
        const World& before;
        const World& after;
        std::span<const Contact> contacts;
        std::span<const std::uint32_t> standing;  ///< balls for which time stood still
        /// The solver bounces balls only when they overlap: a new overlap is no sign of a jam.
        bool overlaps_at_impacts = false;
    };
    /// Whether the trial is free of what a mover must not cause. If not, the shares of the movers
    /// that had a part in it are smaller for the next trial. A trial in which no mover had any
    /// share is accepted as it is.
    ///
    /// What counts are balls that have met a mover in the tick, and balls that those have met. None
    /// of them may
    /// - have crossed an edge of a mover that it met;
    /// - overlap what it met deeper than before, and by more than 0.02 radii;
    /// - stand still after dozens of impacts with movers.
    /// Nor may such a set of balls have more energy than two impacts of each with the mover give,
    /// unless something else throws them too: a flipper, or an edge that kicks.
    /// Nor may a solver have stopped an edge within the tick, unless it was for a ball that the
    /// edge has thrown.
    bool is_sound(const Trial& trial);

    /// Ends the tick: sets the clocks, and the edges to their places.
    void end(World& world) const;

  private:
    struct Active {
        std::uint32_t mover = 0;  ///< index into World::movers
        double share = 1.0;
        double pace = 0.0;  ///< of the fastest end of an edge at share 1, length/s
        // Of the last trial:
        bool has_met = false;  ///< a ball
        bool is_at_fault = false;
    };
    struct Edge {
        std::uint32_t active = 0;  ///< index into active_
        std::uint32_t edge = 0;    ///< index into Mover::edges
        std::uint32_t capsule = 0;
    };
    MoverClock clock_of(const World& world, const Active& active) const;
    const Edge* find(std::uint32_t capsule) const;
    void find_sets(const Trial& trial);
    void blame(std::uint32_t ball);
    static bool separates(const Trial& trial, const Contact& contact);
    bool has_thrown_a_frozen_ball(const Trial& trial) const;
    void check_places(const Trial& trial);
    void check_overlaps(const Trial& trial);
    void check_energies(const Trial& trial);

    std::vector<Active> active_;
    std::vector<Edge> edges_;  // ascending by capsule
    // Scratch. A node is a ball, or behind all balls an active mover.
    DisjointSets sets_;
    std::uint32_t balls_ = 0;
    struct Energy {
        double before = 0.0;
        double after = 0.0;
        double gain = 0.0;  ///< that is allowed
        bool is_thrown = false;
        bool has_mover = false;
    };
    std::vector<Energy> energy_;          // by root
    std::vector<double> most_change_;     // by ball: change of speed by movers; 0: met none
    std::vector<std::uint32_t> impacts_;  // by ball: with movers
};

}  // namespace carom
