#include "physics/event/motion/event.h"

#include <algorithm>

#include "geometry/double_double.h"

namespace carom {

template <typename Real>
bool comes_before(std::uint32_t ball_a, const BallEvent<Real>& a, std::uint32_t ball_b,
                  const BallEvent<Real>& b) {
    if (a.kind == EventKind::none || b.kind == EventKind::none)
        return b.kind == EventKind::none && (a.kind != EventKind::none || ball_a < ball_b);
    if (!(a.time == b.time)) return a.time < b.time;
    if (a.kind != b.kind) return a.kind < b.kind;
    const auto low = [](std::uint32_t ball, const BallEvent<Real>& e) {
        return e.kind == EventKind::ball_ball ? std::min(ball, e.other) : ball;
    };
    const auto high = [](std::uint32_t ball, const BallEvent<Real>& e) {
        return e.kind == EventKind::ball_ball ? std::max(ball, e.other) : e.other;
    };
    if (low(ball_a, a) != low(ball_b, b)) return low(ball_a, a) < low(ball_b, b);
    if (high(ball_a, a) != high(ball_b, b)) return high(ball_a, a) < high(ball_b, b);
    return ball_a < ball_b;
}

template bool comes_before(std::uint32_t, const BallEvent<double>&, std::uint32_t,
                           const BallEvent<double>&);
template bool comes_before(std::uint32_t, const BallEvent<DoubleDouble>&, std::uint32_t,
                           const BallEvent<DoubleDouble>&);

}  // namespace carom
