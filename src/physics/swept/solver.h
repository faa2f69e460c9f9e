#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/swept/candidates.h"
#include "physics/swept/kinematics.h"
#include "physics/swept/paths.h"
#include "physics/swept/prediction.h"
#include "physics/swept/response.h"
#include "physics/swept/schedule.h"
#include "physics/tick/cancellation.h"
#include "physics/tick/work_budget.h"

namespace carom {

/// The solver `swept`: in each substep balls move along straight paths. It finds the first of all
/// impacts, resolves it, and continues with the rest of the substep. No body passes through
/// another, however fast, with one exception: a ball may pass through a turning edge that it grazes
/// by less than 2e-5 of the sum of their radii (geometry/impact.h).
///
/// README.md in this folder has the substep in pseudo-code, the invariants and what the solver gets
/// wrong; tolerances.h has the thresholds.
class SweptSolver {
  public:
    SweptSolver() = default;
    // Its parts refer to one another.
    SweptSolver(const SweptSolver&) = delete;
    SweptSolver& operator=(const SweptSolver&) = delete;

    /// Moves everything by one tick, appends the exchanges to `contacts`, and sets `touched` for
    /// each ball that meets something. `token` is asked between two impacts; once it is cancelled,
    /// the world stays somewhere within the tick. `is_repeated`: TickWork. Pre: `substeps` >= 1.
    void tick(World& world, int substeps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched, CancellationToken& token,
              bool is_repeated = false);

    /// The cells in which the last tick looked for pairs.
    const CellFrame& cells() const { return candidates_.frame(); }
    /// The balls for which time has stood still in the last tick, by index, with repetitions.
    std::span<const std::uint32_t> standing() const { return paths_.standing(); }

  private:
    void resolve_impacts(World& world, std::vector<Contact>& contacts,
                         std::vector<std::uint8_t>& touched, CancellationToken& token);
    std::uint64_t charge(World& world, const SweptEvent& event);
    void predict_after(const World& world, const SweptEvent& event, bool has_changed_edge);

    SweptSubstep step_;
    WorkBudget budget_;
    SweptPaths paths_{step_};
    SweptKinematics kinematics_;
    SweptCandidates candidates_{step_, paths_};
    SweptSchedule schedule_;
    SweptPrediction prediction_{step_, paths_, kinematics_, candidates_, schedule_};
    SweptResponse response_{step_, paths_, kinematics_, candidates_};
};

}  // namespace carom
