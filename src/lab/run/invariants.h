#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/run/escape.h"
#include "level/scene/scene.h"
#include "physics/tick/solver_settings.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Invariants that must hold after every tick, whatever the scene. They are measured from
/// positions, velocities and shapes alone, with code that no solver shares, so that a fault of a
/// solver cannot hide itself.
namespace carom {

/// What a solver promises; an absent value is no promise. `discrete` and `substep` promise nothing:
/// docs/accuracy.md measures their errors.
struct Promise {
    std::optional<double> energy;  ///< largest gain, as a share of the largest energy in play
    /// The energy in play is kinetic and potential, from the lowest ball at the start; else it is
    /// kinetic.
    bool counts_heights = false;
    /// The largest gain in ticks that begin with dense clusters, which `contact` steps
    /// (physics/event/hybrid_step.h).
    double energy_of_clustered = 0.0;
    std::optional<double> overlap;  ///< deepest, as a share of the smaller radius
    /// Deepest overlap of a ball in the cluster of a hybrid step (physics/event/hybrid_step.h).
    double overlap_of_clustered = 0.0;
    /// A pair that starts inside one another has separated once it overlaps by no more than this
    /// share of the smaller radius. Until then a ball that turns back may go as deep as it was.
    double parted = 1e-3;
    /// It lifts overlapping bodies apart, which may add the work done against gravity.
    bool lifts_overlaps = false;
    /// How far gravity may move a ball in a tick, in radii. While there are smaller balls, which a
    /// run notes (run_record.h), all that is promised is finite numbers.
    std::optional<double> most_fall;
    bool keeps_sides = false;  ///< no ball passes through an edge or out of an outline
    bool moves = false;        ///< a ball with a velocity does not stay where it was
};
Promise promise_of(SolverKind solver);
/// How many balls are too small for the promise.
std::size_t count_too_small(const Promise& promise, const World& world);

/// An invariant that does not hold.
struct Breach {
    enum class Kind : std::uint8_t { not_finite, energy, side, escape, overlap, time };
    Kind kind = Kind::not_finite;
    std::uint64_t tick = 0;         ///< the first after which it does not, from 1
    std::optional<BallId> ball;     ///< none: the scene as a whole
    std::optional<BallId> other;    ///< that it overlaps
    std::optional<CapsuleId> edge;  ///< that it overlaps, or has passed
    double amount = 0.0;            ///< energy gained, depth, or speed of a ball that did not move
};
/// "energy", "side" ...
std::string_view name(Breach::Kind kind);
/// One line for people, without its end.
std::string text(const Breach& breach, double rate);

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
///             the way round an end compared with twice the ball's speed
///   escape    no ball is outside of an outline in which it started (EscapeWatch), as long as all
///             of the outlines' edges are where they were, and stop all balls from both sides
///   overlap   no two bodies that collide overlap deeper than the solver promises, and than the
///             rounding of their coordinates. A pair that starts deeper, as under `use overlap`, is
///             exempt until it has separated. Held, moving and one-way edges, held balls, and edges
///             on a torus are not checked
///   time      the tick has advanced, and no ball that has a velocity has stayed exactly where it
///             was, unless the solver has reported that time stood still for a ball
///
/// Cost: a sort of the balls by x, then pairs of balls that are near along x, and every edge with
/// the balls near it along x.
class InvariantCheck {
  public:
    InvariantCheck(const Scene& scene, SolverKind solver);

    /// Takes over what commands and the rules of a game have changed since the last tick, which is
    /// not the solver's doing: energy that they added or removed becomes part of the baseline, and
    /// pairs that they made overlap are exempt until they have separated. Pre: called before every
    /// tick.
    void note_start(const World& world);
    /// Pre: called after every tick. The first breach in the order of the list; none: all hold.
    /// `contacts`: those of the tick; only movers need them.
    std::optional<Breach> note_tick(const World& world, bool stood_still,
                                    std::span<const Contact> contacts = {});

  private:
    using Pair = std::pair<std::uint64_t, std::uint64_t>;

    std::optional<Breach> check_finite(const World& world) const;
    std::optional<Breach> check_energy(const World& world, std::span<const Contact> contacts);
    double energy_in_play(const World& world) const;
    double most_work_of_movers(const World& world, std::span<const Contact> contacts) const;
    std::optional<Breach> check_sides(const World& world) const;
    std::optional<Breach> check_overlap(const World& world);
    std::optional<Breach> check_time(const World& world, bool stood_still) const;
    void exempt_deep_pairs(const World& world);
    void sort(const World& world);
    void remember(const World& world);
    bool is_exempt(const Pair& pair) const;
    /// visit(pair, depth, smaller radius, ball, other ball or none, edge or none) of all overlaps.
    template <typename Visit>
    void for_each_overlap(const World& world, Visit&& visit) const;

    Promise promise_;
    EscapeWatch escape_;
    std::size_t escaped_ = 0;
    std::vector<std::pair<CapsuleId, Capsule>> outlines_;  // as they were at the start
    std::vector<std::pair<CapsuleId, Capsule>> moved_;     // edges of movers, before the tick
    bool reports_impulses_ = true;                         // the solver, of all contacts
    Stamps stamps_;                                        // after the last tick
    double energy_ = 0.0;                                  // after the last tick
    std::uint64_t tick_ = 0;
    std::uint32_t next_ball_ = 0;  // before the tick, like the three below
    std::vector<BallId> ids_;
    std::vector<Vec2> position_;
    std::vector<Vec2> velocity_;
    std::vector<std::uint32_t> order_;  // of balls, by x
    double widest_ = 0.0;               // radius
    double baseline_ = 0.0;             // energy at the start, and what was added since
    double clustered_gain_ = 0.0;       // beyond baseline_, from hybrid steps
    bool is_hybrid_step_ = false;       // the tick begins with dense clusters
    double ground_ = 0.0;               // potential for each unit of mass, of the lowest ball
    double scale_ = 0.0;                // the largest energy in play
    std::vector<Pair> exempt_;          // pairs that started too deep, ascending
};

}  // namespace carom
