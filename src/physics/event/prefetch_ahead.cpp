#include "physics/event/engine.h"

// Fetching from memory before it is needed.
namespace carom {

// What the events to come are going to need, as far as is known by now where that is: one ball a
// call, which comes by four times. Until the last time no step of it is a branch that nobody can
// foretell; what is fetched then is most of it, and much less where a ball goes from cell to cell
// or is going to look for another whom to meet.
template <typename Real>
void EventEngine<Real>::look_ahead() {
    const std::optional<std::uint32_t> found = queue_.scout();
    if (!found) return;
    const auto earlier = [this](std::uint32_t by) -> Coming& {
        return coming_[(came_ - by) % coming_.size()];
    };
    ++came_;
    earlier(0).ball = *found;
    balls_.fetch(*found);

    Coming& second = earlier(2);
    const EventPlan<Real>& plan = balls_.plan(second.ball);
    const Event coming = plan.coming();
    second.partner = select(coming.kind == Kind::ball_ball, coming.other, second.ball);
    second.direction =
        select(coming.kind == Kind::crossing, coming.other, EventCells<Real>::no_direction);
    second.cell = cells_.next_cell(plan.place.cell, second.direction);
    cells_.fetch_heads(second.cell);
    balls_.fetch(second.partner);
    queue_.fetch(second.partner);

    Coming& third = earlier(4);
    third.partner_cell = balls_.plan(third.partner).place.cell;
    cells_.fetch_heads(third.partner_cell);

    const Coming& last = earlier(6);
    if (last.direction != EventCells<Real>::no_direction) {
        cells_.fetch_new(balls_, last.cell, last.direction);
        return;
    }
    cells_.fetch_near(balls_, last.cell);
    if (balls_.plan(last.ball).coming().other_version != balls_[last.partner].version) return;
    cells_.fetch_near(balls_, last.partner_cell);
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom
