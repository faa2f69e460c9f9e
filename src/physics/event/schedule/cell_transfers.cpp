#include "physics/event/schedule/cell_transfers.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/conservative_advancement.h"
#include "physics/event/motion/tolerances.h"
#include "physics/event/motion/trajectory.h"

namespace carom {
namespace {

template <typename Real>
BallEvent<Real> transfer_at(const Real& time, std::uint32_t what) {
    return {time, EventKind::cell_transfer, 0, 0, what, 0};
}

/// The time in which a body covers the distance `far`, s: |v| t + |a| t^2 / 2 = far, by the root
/// without cancellation. Infinity for a body at rest that nothing accelerates.
template <typename Real>
Real time_to_cover(const Real& far, const Real& speed, const Real& acceleration) {
    const Real root = speed + square_root(speed * speed + Real(2.0) * acceleration * far);
    if (!(root > Real{})) return Real(std::numeric_limits<double>::infinity());
    return Real(2.0) * far / root;
}

}  // namespace

template <typename Real>
inline void CellTransfers<Real>::predict_through(std::uint32_t side, std::uint32_t ball,
                                                 const Trajectory<Real>& trajectory, bool is_simple,
                                                 const BallState<Real>& now, const Real& last,
                                                 BallEvent<Real>& best) const {
    const CellFrame& frame = cells_.frame();
    const auto [columns, rows] = cell_transfer::steps[side];
    const bool is_column = columns != 0;
    const int place = is_column ? balls_.plan(ball).place.column : balls_.plan(ball).place.row;
    const int count = is_column ? frame.columns : frame.rows;
    const int step = columns + rows;
    if (!frame.wraps && (step > 0 ? place >= count - 1 : place <= 0)) return;
    const double origin = is_column ? frame.origin.x : frame.origin.y;
    const double width = is_column ? frame.cell.x : frame.cell.y;
    const Real border(origin + width * (step > 0 ? place + 1 : place));
    const Real sign(static_cast<double>(step));
    const auto along = [is_column](const Vector<Real>& v) { return is_column ? v.x : v.y; };
    const ToiTolerance<Real> exact{};
    if (is_simple) {
        const bool is_straight = trajectory.acceleration == Vector<Real>{};
        if (is_straight && !(along(now.velocity) * sign > Real{})) return;
        const auto since = quadratic_time_of_impact<Real>(
            {(border - along(now.position)) * sign, -along(now.velocity) * sign,
             -along(trajectory.acceleration) * sign},
            exact);
        if (since) keep_earlier(ball, transfer_at<Real>(scene_.now + *since, side), best);
        return;
    }
    // A parabola that goes no slower crosses a line a little behind the border no later. Whether
    // the ball has crossed the border itself by then decides; if not, it predicts again.
    const Real delay(
        std::min(most_transfer_delay * width, 0.5 * (edge_reach - 1.0) * cells_.largest()));
    const Real most = most_acceleration(trajectory, scene_.field, scene_.now);
    const auto since = quadratic_time_of_impact<Real>(
        {(border - along(now.position)) * sign + delay, -along(now.velocity) * sign, -most}, exact);
    if (!since) return;
    const Real time = scene_.now + *since;
    if (!(time < last)) return;
    const Vector<Real> there = state_at(trajectory, scene_.field, time).position;
    const bool has_crossed = (border - along(there)) * sign <= Real{};
    keep_earlier(ball, transfer_at(time, has_crossed ? side : cell_transfer::predict_again), best);
}

template <typename Real>
void CellTransfers<Real>::predict(std::uint32_t ball, BallEvent<Real>& best) const {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    if (trajectory.motion == Motion::resting || trajectory.motion == Motion::still) return;
    const BallState<Real> now = state_at(trajectory, scene_.field, scene_.now);
    if (cells_.is_oversized(balls_, ball)) {
        if (scene_.world->model().wrap) predict_next_images(trajectory, now, ball, best);
        return;
    }
    const bool is_simple = is_parabola(trajectory, scene_.field);
    const Real last =
        trajectory.motion == Motion::turning ? piece_end(trajectory, scene_.field) : best.time;
    for (std::uint32_t side = 0; side < cell_transfer::sides; ++side)
        predict_through(side, ball, trajectory, is_simple, now, last, best);
}

template <typename Real>
void CellTransfers<Real>::predict_next_images(const Trajectory<Real>& trajectory,
                                              const BallState<Real>& now, std::uint32_t ball,
                                              BallEvent<Real>& best) const {
    const Real far(oversized_periods * std::min(scene_.period.x, scene_.period.y));
    const Real since = time_to_cover(far, length(now.velocity),
                                     most_acceleration(trajectory, scene_.field, scene_.now));
    keep_earlier(ball, transfer_at(scene_.now + since, cell_transfer::predict_again), best);
}

template <typename Real>
void CellTransfers<Real>::predict_restart(std::uint32_t ball, BallEvent<Real>& best) const {
    const LinearPart<Real>& line = balls_[ball].line;
    if (line.motion != Motion::free && !is_on_cloth(line)) return;
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    const Real far(most_periods * std::min(scene_.period.x, scene_.period.y));
    // A rough bound first: nearly all balls have another event before.
    const auto sum_of_parts = [](const Vector<Real>& v) { return absolute(v.x) + absolute(v.y); };
    const Real since = best.time - trajectory.time;
    const Real most =
        sum_of_parts(trajectory.velocity) + sum_of_parts(trajectory.acceleration) * since;
    if (most * since < far) return;
    // Drag only shortens the way.
    const Real time = trajectory.time + time_to_cover(far, length(trajectory.velocity),
                                                      length(trajectory.acceleration));
    if (!(time < Real(std::numeric_limits<double>::infinity()))) return;
    keep_earlier(
        ball, transfer_at(time < scene_.now ? scene_.now : time, cell_transfer::restart_in_frame),
        best);
}

template class CellTransfers<double>;
template class CellTransfers<DoubleDouble>;

}  // namespace carom
