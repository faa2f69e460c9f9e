#include "physics/event_engine.h"

// Fetching from memory before it is needed.
namespace carom {

// What the events to come are going to need, as far as is known by now where that is: one ball a
// call, which comes by four times. No step of it is a branch that nobody can foretell.
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
    second.partner = select(plan.coming.kind == Kind::ball_ball, plan.coming.other, second.ball);
    // Where it is going to look around itself.
    constexpr std::uint32_t nowhere = 4;
    const std::uint32_t way =
        select(plan.coming.kind == Kind::crossing, plan.coming.other, nowhere);
    const auto columns = static_cast<std::uint32_t>(cells_.frame().columns);
    second.cell = plan.place.cell + select(way == 0, 1, 0) - select(way == 1, 1, 0) +
                  select(way == 2, columns, 0) - select(way == 3, columns, 0);
    cells_.fetch_heads(second.cell);
    balls_.fetch(second.partner);
    queue_.fetch(second.partner);

    Coming& third = earlier(4);
    third.partner_cell = balls_.plan(third.partner).place.cell;
    cells_.fetch_heads(third.partner_cell);

    const Coming& last = earlier(6);
    cells_.fetch_near(balls_, last.cell);
    cells_.fetch_near(balls_, last.partner_cell);
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom
