#pragma once

#include <cstdint>

#include "physics/event/motion/ball_cells.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"

namespace carom {

/// Predicts when a ball leaves its cell. Cell transfers are bookkeeping: they never change a
/// trajectory, so their times need not be exact. A transfer of a curved trajectory is found up to
/// `most_transfer_delay` of a cell late, never early: a ball that has just crossed a border cannot
/// be reported as crossing back at once, and cells are so much wider than need be.
template <typename Real>
class CellTransfers {
  public:
    CellTransfers(const EventScene<Real>& scene, const BallTable<Real>& balls,
                  const BallCells<Real>& cells)
        : scene_(scene), balls_(balls), cells_(cells) {}

    /// Sets `best` to the ball's next transfer if that comes before it.
    void predict(std::uint32_t ball, BallEvent<Real>& best) const;
    /// The same for uniform motion, without a branch on the direction.
    void predict_uniform(std::uint32_t ball, BallEvent<Real>& best) const;
    /// On a torus: when the trajectory has led `most_periods` away, and must start again in the
    /// frame before its image index overflows. The time depends on the trajectory alone.
    void predict_restart(std::uint32_t ball, BallEvent<Real>& best) const;

  private:
    /// Inlined, so that each side is compiled by itself.
    [[gnu::always_inline]] void predict_through(std::uint32_t side, std::uint32_t ball,
                                                const Trajectory<Real>& path, bool is_simple,
                                                const BallState<Real>& now, const Real& last,
                                                BallEvent<Real>& best) const;

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const BallCells<Real>& cells_;
};

}  // namespace carom
