#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "geometry/f64x2.h"
#include "physics/event/motion/ball_cells.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"
#include "physics/memory/branchless.h"

namespace carom {

/// Predicts when a ball leaves its cell. Cell transfers are bookkeeping: but for the restart on a
/// torus they never change a trajectory, so their times need not be exact. A transfer of a curved
/// trajectory is found up to `most_transfer_delay` of a cell late, never early: a ball that has
/// just crossed a border cannot be reported as crossing back at once, and cells are wider by that
/// margin.
template <typename Real>
class CellTransfers {
  public:
    CellTransfers(const EventScene<Real>& scene, const BallTable<Real>& balls,
                  const BallCells<Real>& cells)
        : scene_(scene), balls_(balls), cells_(cells) {}

    struct Crossing {
        Real time{};             ///< s; infinity: never
        std::uint32_t side = 0;  ///< of cell_transfer

        BallEvent<Real> event() const {
            const bool is_one = time < Real(std::numeric_limits<double>::infinity());
            return {time, is_one ? EventKind::cell_transfer : EventKind::none, 0, 0, side, 0};
        }
    };

    /// Sets `best` to the ball's next transfer if that comes before it. An oversized ball is in no
    /// cell; on a torus it predicts again after a part of a period instead (`oversized_periods`).
    void predict(std::uint32_t ball, BallEvent<Real>& best) const;
    /// When a ball in uniform motion leaves its cell, without a branch on the direction.
    /// `may_wrap`: whether the grid may be that of a torus.
    template <bool may_wrap>
    Crossing uniform_crossing(std::uint32_t ball) const;
    /// On a torus: when the trajectory has led `most_periods` away, and must start again in the
    /// frame before its image index overflows. The time depends on the trajectory alone.
    void predict_restart(std::uint32_t ball, BallEvent<Real>& best) const;

  private:
    void predict_next_images(const Trajectory<Real>& trajectory, const BallState<Real>& now,
                             std::uint32_t ball, BallEvent<Real>& best) const;
    /// Inlined, so that each side is compiled by itself.
    [[gnu::always_inline]] void predict_through(std::uint32_t side, std::uint32_t ball,
                                                const Trajectory<Real>& trajectory, bool is_simple,
                                                const BallState<Real>& now, const Real& last,
                                                BallEvent<Real>& best) const;

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const BallCells<Real>& cells_;
};

// Doubles compute both axes side by side. Inlined: a gas spends much of its time here.
template <typename Real>
template <bool may_wrap>
inline auto CellTransfers<Real>::uniform_crossing(std::uint32_t ball) const -> Crossing {
    const LinearPart<Real>& line = balls_[ball].line;
    const CellPlace& own = balls_.plan(ball).place;
    const CellFrame& frame = cells_.frame();
    const bool is_bounded = !may_wrap || !frame.wraps;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Crossing crossing;
    bool is_y = false;
    if constexpr (std::is_same_v<Real, double>) {
        const F64x2 speed{line.velocity.x, line.velocity.y};
        const F64x2 place{line.position.x, line.position.y};
        const F64x2 origin{frame.origin.x, frame.origin.y};
        const F64x2 width{frame.cell.x, frame.cell.y};
        const F64x2 last{static_cast<double>(frame.columns), static_cast<double>(frame.rows)};
        const F64x2 cell{static_cast<double>(own.column), static_cast<double>(own.row)};
        const F64x2 zero{};
        const F64x2 one{1.0, 1.0};
        const F64x2 never{infinity, infinity};
        const F64x2 border = cell + (speed > zero ? one : zero);
        const F64x2 crossed = line.time + ((origin + width * border) - place) / speed;
        const F64x2 no_earlier = at_least(F64x2{scene_.now, scene_.now}, crossed);
        auto is_crossing = speed != zero;
        if (is_bounded) is_crossing &= (border > zero) & (border < last);
        const F64x2 time = is_crossing ? no_earlier : never;
        is_y = time[1] < time[0];
        crossing.time = time[1] < time[0] ? time[1] : time[0];
    } else {
        const Real zero{};
        const Real never(infinity);
        const auto along_axis = [&](const Real& from, const Real& speed, int place, int count,
                                    double origin, double width) {
            const int border = place + static_cast<int>(speed > zero);
            if (speed == zero || (is_bounded && (border <= 0 || border >= count))) return never;
            const Real time = line.time + (Real(origin + width * border) - from) / speed;
            return time < scene_.now ? scene_.now : time;
        };
        const Real x = along_axis(line.position.x, line.velocity.x, own.column, frame.columns,
                                  frame.origin.x, frame.cell.x);
        const Real y = along_axis(line.position.y, line.velocity.y, own.row, frame.rows,
                                  frame.origin.y, frame.cell.y);
        is_y = y < x;
        crossing.time = is_y ? y : x;
    }
    const auto to_x = static_cast<std::uint32_t>(!(line.velocity.x > Real{}));
    const auto to_y = static_cast<std::uint32_t>(!(line.velocity.y > Real{}));
    crossing.side = select(is_y, cell_transfer::up + to_y, to_x);
    return crossing;
}

}  // namespace carom
