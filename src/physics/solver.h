#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/broad_phase/cell_frame.h"
#include "physics/tick/solver_settings.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// The solvers. Each advances a world by one tick; they differ in what they cost and in what they
/// get wrong (docs/physics.md).
namespace carom {

/// The solvers that this carom has, cheapest first.
std::span<const SolverKind> solvers_available();

/// Whether the solver can simulate this model. `contact` supports no cloth; `discrete` and
/// `substep` support no seesaws. Model::modulus counts as supported everywhere, though only `event`
/// has impacts that last.
bool supports(SolverKind kind, const Model& model);

/// Whether the solver may step dense clusters with `contact` (event/hybrid_step.h): `event` does,
/// where gravity acts, balls meet balls or seesaws, and the scene loses energy (`loses_energy`).
bool uses_hybrid_step(const Model& model, const SolverSettings& settings);

/// What `auto` picks for a world, by the estimates of solver_cost.h, and the reason, with what else
/// was weighed. It depends on the world alone, never on a clock.
///
/// Without a Need: the cheapest of `swept`, `contact` and `event`; or `event`, which is the most
/// accurate, if it costs at most 1.5 times as much. With one: see Need.
struct SolverPick {
    SolverSettings settings;
    std::string reason;
};
SolverPick pick_solver(const World& world);

/// How a tick ended.
enum class TickOutcome : std::uint8_t {
    done,
    cancelled,  ///< `keep_going` said so: the world is as it was before the tick
    /// Done, but for some balls (Solver::standing) or seesaws time stood still for a part of the
    /// tick.
    stood_still
};

/// Advances worlds. Holds settings and scratch memory, but nothing that the next tick depends on:
/// one solver may serve several worlds in turn, and a snapshot of the world alone is enough to go
/// on. The exception is `event extended` (SolverSettings::extended).
class Solver {
  public:
    /// Pre: settings.kind is one of solvers_available().
    explicit Solver(const SolverSettings& settings);
    Solver(Solver&&) noexcept;
    Solver& operator=(Solver&&) noexcept;
    ~Solver();

    const SolverSettings& settings() const;

    /// Advances by one tick: emitters, kinematic bodies, motion and collisions, sinks.
    ///
    /// A long tick of `substep`, `swept` and `event`, and of `contact` where nothing can press,
    /// calls `keep_going` now and then, unless it is empty. If it returns false, the tick is
    /// cancelled, and the world is as it was before. `discrete`, and `contact` elsewhere, never
    /// call it: the work of their ticks is bounded.
    TickOutcome tick(World& world, const std::function<bool()>& keep_going = {});

    /// The exchanges of momentum of the last tick, in the order in which they were made. Valid
    /// until the next tick.
    std::span<const Contact> contacts() const;

    /// What the constraints of `contact` gave in the last tick to balls that kinematic bodies
    /// press, and contacts() does not report, which has each constraint once: an entry for each
    /// constraint and substep, with what it gave by its normal. One that contacts() reports stands
    /// here once more, with its impulse below 0: the sum of both is what kinematic bodies gave.
    /// Empty under solvers without constraints. Valid until the next tick.
    std::span<const Contact> pressing() const;

    /// The balls for which time stood still in a part of the last tick, ascending: a limit of work
    /// was reached (tick/work_budget.h), or the solver could follow their paths no further
    /// (docs/physics.md). They have kept their velocities. Of a tick that hands, movers or a hybrid
    /// step repeat, those of all trials, also of trials that have been rejected. Valid until the
    /// next tick.
    std::span<const BallId> standing() const;
    /// For how many seesaws time stood still in a part of the last tick: world/seesaw.h.
    std::size_t standing_seesaws() const;

    /// The cells in which the last tick looked for neighbours; one cell before the first tick.
    const CellFrame& cells() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// For how many balls and seesaws time stood still in a tick.
struct Standing {
    std::size_t balls = 0;
    std::size_t seesaws = 0;
};
inline Standing standing_in(const Solver& solver) {
    return {solver.standing().size(), solver.standing_seesaws()};
}

}  // namespace carom
