#include "physics/event/schedule/schedule.h"
#include "physics/memory/branchless.h"

namespace carom {

template <typename Real>
double Schedule<Real>::queue_time(std::uint32_t ball) const {
    const BallEvent<Real> next = balls_.plan(ball).next_event();
    return next.kind == EventKind::none ? EventQueue::never : static_cast<double>(next.time);
}

template <typename Real>
void Schedule<Real>::rebuild() {
    upcoming_.fill({});
    queue_.build(
        balls_.size(), [this](std::uint32_t ball) { return queue_time(ball); },
        [this](std::uint32_t a, std::uint32_t b) { return is_before(a, b); });
}

template <typename Real>
void Schedule<Real>::update(std::uint32_t ball) {
    queue_.update(ball, queue_time(ball),
                  [this](std::uint32_t a, std::uint32_t b) { return is_before(a, b); });
}

// Prefetches what events to come will read, as far as it is known. Each call takes up one more
// ball, and each ball passes by four times: for itself, its partner, its partner's cell, and the
// balls around both. Until the last time no step branches on what cannot be predicted.
template <typename Real>
void Schedule<Real>::prefetch() {
    const std::optional<std::uint32_t> found = queue_.next_to_prefetch();
    if (!found) return;
    const auto earlier = [this](std::uint32_t by) -> Upcoming& {
        return upcoming_[(last_upcoming_ - by) % upcoming_.size()];
    };
    ++last_upcoming_;
    earlier(0).ball = *found;
    balls_.prefetch(*found);

    Upcoming& second = earlier(2);
    const BallPlan<Real>& plan = balls_.plan(second.ball);
    const BallEvent<Real> next = plan.next_event();
    second.partner = select(next.kind == EventKind::ball_ball, next.other, second.ball);
    second.direction =
        select(next.kind == EventKind::cell_transfer, next.other, BallCells<Real>::no_direction);
    second.cell = cells_.next_cell(plan.place.cell, second.direction);
    cells_.prefetch_heads(second.cell);
    balls_.prefetch(second.partner);
    queue_.prefetch(second.partner);

    Upcoming& third = earlier(4);
    third.partner_cell = balls_.plan(third.partner).place.cell;
    cells_.prefetch_heads(third.partner_cell);

    const Upcoming& last = earlier(6);
    if (last.direction != BallCells<Real>::no_direction) {
        cells_.prefetch_new(balls_, last.cell, last.direction);
        return;
    }
    cells_.prefetch_near(balls_, last.cell);
    if (balls_.plan(last.ball).next_event().other_version != balls_[last.partner].version) return;
    cells_.prefetch_near(balls_, last.partner_cell);
}

template class Schedule<double>;
template class Schedule<DoubleDouble>;

}  // namespace carom
