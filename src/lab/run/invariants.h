#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "lab/run/breach.h"
#include "lab/run/energy_check.h"
#include "lab/run/escape.h"
#include "lab/run/promise.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Invariants that must hold after every tick, whatever the scene. They are measured from
/// positions, velocities and shapes alone, with code that no solver shares, so that a fault of a
/// solver cannot hide itself.
namespace carom {

/// Checks a run, tick by tick.
///
///   finite    all positions and velocities are finite numbers
///   energy    kinetic plus potential energy has not grown beyond its value at the start. Where
///             something may add energy (hands, flippers, kicking edges, gravity on a torus, the
///             ramps of pinball), a gain is allowed; so is any change when balls come or go. What
///             `contact` gives in a hybrid step of `event` stays given. Movers may add the work
///             that they do in the contacts of the tick, and no more; where `contact` steps, which
///             does not report all of its contacts, they may add anything
///   side      the centre of no ball has crossed the spine of a fixed edge that is solid on both
///             sides, unless it can have gone round an end: the chord of the tick is tested, and
///             the way round an end compared with twice the ball's speed, which is at least that
///             after each of its contacts in the tick: light balls between heavy ones are fast. A
///             ball that starts inside an edge has no side of it until it has separated
///   escape    no ball is outside of an outline in which it started (EscapeWatch), as long as all
///             of the outlines' edges are where they were, and stop all balls from both sides
///   overlap   no two bodies that collide overlap deeper than the solver promises, and than the
///             rounding of their coordinates. A pair that starts deeper, as under `use overlap`, is
///             exempt until it has separated. Where `contact` lifts bodies apart, what is lifted
///             may be pressed into others: while a ball is deeper in another than promised, all
///             pairs of these two are exempt, too. Held, moving and one-way edges, held balls, and
///             edges on a torus are not checked
///   time      the tick has advanced, and no ball that has a velocity has stayed exactly where it
///             was, unless the solver has reported that time stood still for a ball, or
///             `contact` has stepped a ball that is wedged (time_check.h)
///
/// Cost: a sort of the balls by x, then pairs of balls that are near along x, and every edge with
/// the balls near it along x.
class InvariantCheck {
  public:
    InvariantCheck(const Scene& scene, SolverKind solver);

    /// From now on this solver's promises count, starting from the present world. Pre: called
    /// before `note_start`. Nothing happens if it is the solver already.
    void change_solver(SolverKind solver, const World& world);
    /// Takes over what commands and the rules of a game have changed since the last tick, which is
    /// not the solver's doing: energy that they added or removed becomes part of the baseline, and
    /// pairs that they made overlap are exempt until they have separated. Pre: called before every
    /// tick.
    void note_start(const World& world);
    /// Pre: called after every tick. The first breach in the order of the list; none: all hold.
    /// `contacts`: those of the tick. Sides and the work of movers need them.
    std::optional<Breach> note_tick(const World& world, bool stood_still,
                                    std::span<const Contact> contacts = {});

  private:
    using Pair = std::pair<std::uint64_t, std::uint64_t>;

    std::optional<Breach> check_finite(const World& world) const;
    std::optional<Breach> check_sides(const World& world, std::span<const Contact> contacts) const;
    std::optional<Breach> check_overlap(const World& world);
    std::optional<Breach> check_time(const World& world, bool stood_still) const;
    void exempt_deep_pairs(const World& world);
    void sort(const World& world);
    void remember(const World& world);
    static Pair pair_with_edge(BallId ball, CapsuleId edge);
    bool is_exempt(const Pair& pair) const;
    /// Leaves the pair out until it has separated. `share`: of the smaller radius, by which
    /// it overlaps. Afterwards `exempt_` and `lifted_` must be sorted.
    void exempt(const Pair& pair, double share, const Breach& bodies);
    /// visit(pair, depth, smaller radius, ball, other ball or none, edge or none) of all overlaps.
    template <typename Visit>
    void for_each_overlap(const World& world, Visit&& visit) const;

    SolverKind solver_;
    Promise promise_;
    EnergyCheck energy_;
    EscapeWatch escape_;
    std::size_t escaped_ = 0;
    std::vector<std::pair<CapsuleId, Capsule>> outlines_;  // as they were at the start
    Stamps stamps_;                                        // after the last tick
    std::uint64_t tick_ = 0;                               // before the tick, like the three below
    std::vector<BallId> ids_;
    std::vector<Vec2> position_;
    std::vector<Vec2> velocity_;
    std::vector<std::uint32_t> order_;  // of balls, by x
    double widest_ = 0.0;               // radius
    std::vector<Pair> exempt_;          // pairs that started too deep, ascending
    std::vector<BallId> lifted_;  // balls of the exempt pairs that are too deep now, ascending
};

}  // namespace carom
