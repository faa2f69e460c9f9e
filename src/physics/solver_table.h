#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "physics/solver.h"

/// The table of solvers. A new solver is a row here with a `SolverMethod`, its name and settings in
/// solver_settings, and the files that compute.
namespace carom {

/// What a solver is given for a tick besides the world.
struct TickWork {
    /// Empty; receives the exchanges of momentum in the order in which they are made. Bodies are
    /// named by their indices in the world.
    std::vector<Contact>& contacts;
    /// By ball, all 0; becomes 1 for each ball that meets something. `contact` marks only the balls
    /// that press on something when the tick ends. For stop_slow_balls.
    std::vector<std::uint8_t>& touched;
    /// Called now and then to ask whether to continue. Empty: the tick cannot be cancelled.
    const std::function<bool()>& keep_going;
    /// A tick whose bodies may not sink into one another, at any cost: SolverMethod::can_be_strict.
    bool is_strict = false;
    /// The tick has been computed before, with longer displacements of hands or movers: what that
    /// cost is taken from its budget (tick/work_budget.h).
    bool is_repeated = false;
};

/// How one solver moves a world through a tick: one virtual call a tick, above all loops.
class SolverMethod {
  public:
    virtual ~SolverMethod() = default;

    /// Moves all balls and held edges by one tick. Leaves in the world the memory of solvers that
    /// the next tick may use (trajectories, contacts), and drops the rest, unless the tick is
    /// cancelled: then the caller puts the world back.
    virtual TickOutcome advance(World& world, TickWork work) = 0;

    /// Whether bodies may sink into one another in a tick of this world, and sink in less in a
    /// strict one.
    virtual bool can_be_strict() const { return false; }

    /// The balls for which time stood still in a part of the last tick, by index, with repetitions.
    virtual std::span<const std::uint32_t> standing() const { return {}; }

    /// The same for attempts at the tick that the solver rejected (event/hybrid_step.h).
    virtual std::span<const std::uint32_t> standing_before() const { return {}; }

    /// Solver::pressing, with bodies named by their indices in the world.
    virtual std::span<const Contact> pressing() const { return {}; }

    /// The cells in which the last tick looked for neighbours.
    virtual const CellFrame& cells() const = 0;
};

/// One solver. Rows stand in the order of SolverKind, cheapest solver first.
struct SolverRow {
    SolverKind kind;
    /// Whether it moves balls on cloth as Model::cloth says, and turns seesaws. Every solver
    /// supports everything else in a model.
    bool supports_cloth;
    bool supports_hinges;
    /// Whether it notices an impact by the overlap of the bodies.
    bool overlaps_at_impacts;
    /// Whether a tick of this world can take so long that it asks `keep_going`.
    bool (*can_cancel)(const World& world);
    std::unique_ptr<SolverMethod> (*make)(const SolverSettings& settings);
};

std::span<const SolverRow> solver_table();

inline const SolverRow& row_of(SolverKind kind) {
    return solver_table()[static_cast<std::size_t>(kind)];
}

}  // namespace carom
