#pragma once

#include <cstdint>
#include <vector>

#include "physics/discrete/kinematics.h"
#include "physics/discrete/motion.h"
#include "physics/discrete/separation.h"
#include "physics/discrete/shared_neighbours.h"
#include "physics/discrete/step.h"
#include "physics/tick/cancellation.h"

namespace carom {

/// The solvers `discrete` and `substep`: move, separate overlaps, exchange momentum. `discrete` is
/// one update of one step. README.md in this folder has the loop, the invariants and what the
/// solvers get wrong.
class OverlapSolver {
  public:
    OverlapSolver() = default;
    // Its parts refer to one another.
    OverlapSolver(const OverlapSolver&) = delete;
    OverlapSolver& operator=(const OverlapSolver&) = delete;

    /// Moves everything by one tick, appends the exchanges to `contacts`, and sets `touched` for
    /// each ball that meets something. `token` is asked between two steps; once it is cancelled,
    /// the world stays as the last step left it. Pre: `updates` and `steps` >= 1.
    void tick(World& world, int updates, int steps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched, CancellationToken& token);

    /// The cells of the smallest balls.
    const CellFrame& cells() const { return neighbours_.list().grid().finest(); }

  private:
    void update(World& world, int steps, double end_time, std::vector<Contact>& contacts,
                CancellationToken& token);
    void move(World& world);

    OverlapStep step_;
    OverlapKinematics kinematics_;
    OverlapMotion motion_{step_, kinematics_};
    SharedNeighbours neighbours_{step_};
    OverlapSeparation separation_{step_, kinematics_, motion_, neighbours_};
};

}  // namespace carom
