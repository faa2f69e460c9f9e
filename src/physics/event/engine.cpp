#include "physics/event/engine.h"

#include "physics/event/motion/tolerances.h"

namespace carom {

template <typename Real>
EventOutcome EventEngine<Real>::tick(World& world, std::vector<Contact>& contacts,
                                     std::vector<std::uint8_t>& touched,
                                     const std::function<bool()>& keep_going, bool is_repeated) {
    begin(world, keep_going, is_repeated);
    if (work_.is_cancelled()) return EventOutcome::cancelled;
    const ImpactRecord record{contacts, touched};
    Real limit = end_of_events();
    while (true) {
        const std::optional<std::uint32_t> first = schedule_.first();
        if (!first || !(balls_.plan(*first).next_event().time <= limit)) {
            if (scene_.end < kinematic_.next_stop()) break;
            if (!turn_back_at_stop()) return EventOutcome::cancelled;
            limit = end_of_events();
            continue;
        }
        const std::uint32_t ball = *first;
        const BallEvent<Real> event = balls_.plan(ball).next_event();
        work_.count_event();
        if (!work_.may_go_on()) return EventOutcome::cancelled;
        if (scene_.now < event.time) scene_.now = event.time;
        const bool is_handled =
            trajectories_.are_all_straight() && uniform_.handle(ball, event, record);
        if (!is_handled) handle(ball, event, record);
        if (kinematic_.take_stopped()) {
            predict_all();
            if (work_.is_cancelled()) return EventOutcome::cancelled;
            limit = end_of_events();
        }
        if (work_.is_over_budget()) charge(ball, event);
    }
    scene_.now = scene_.end;
    standstill_.end_tick();
    sync_.write(world, !standstill_.is_empty());
    return EventOutcome::done;
}

// Balls have no more events before then: the end of the tick, or the stop of a seesaw.
template <typename Real>
Real EventEngine<Real>::end_of_events() const {
    return lesser(scene_.end, kinematic_.next_stop());
}

// Returns false if the tick is cancelled.
template <typename Real>
bool EventEngine<Real>::turn_back_at_stop() {
    work_.count_event();
    if (!work_.may_go_on()) return false;
    if (scene_.now < kinematic_.next_stop()) scene_.now = kinematic_.next_stop();
    kinematic_.bounce_at_stops();
    kinematic_.take_stopped();
    predict_all();
    return !work_.is_cancelled();
}

template <typename Real>
void EventEngine<Real>::begin(World& world, const std::function<bool()>& keep_going,
                              bool is_repeated) {
    work_.begin(keep_going, world.balls().size(), is_repeated);
    guard_.begin_tick();
    standstill_.begin_tick();
    scene_.world = &world;
    scene_.field = field_of<Real>(world.model());
    scene_.period = world.model().wrap ? size(*world.model().wrap) : Vec2{};
    scene_.now = Real(world.time());
    scene_.end = Real(static_cast<double>(world.tick() + 1) / world.rate());
    const auto begun = sync_.begin();
    switch (begun) {
        case WorldSync<Real>::Begun::continued:
            break;
        case WorldSync<Real>::Begun::changed:
            for (const std::uint32_t ball : sync_.changed())
                predict(ball);
            break;
        case WorldSync<Real>::Begun::rebuilt:
            cluster_.reset(balls_.size());
            predict_all();
    }
    // In uniform motion no speed grows between impacts.
    if (begun != WorldSync<Real>::Begun::continued || !trajectories_.are_all_straight())
        stop_untimed();
}

// Time stands still for balls that are too fast for the rounding of time.
template <typename Real>
void EventEngine<Real>::stop_untimed() {
    const Balls& balls = scene_.world->balls();
    const double rounding = precision<Real> * static_cast<double>(scene_.end);
    const double most = most_untimed_travel / rounding;  // radii/s
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
        const double limit = most * balls.radius[i];
        if (dot(balls.velocity[i], balls.velocity[i]) <= limit * limit) continue;
        if (work_.is_cancelled()) return;
        if (balls_[i].line.motion == Motion::held) continue;
        standstill_.stop(i);
        predict(i);
    }
}

template <typename Real>
void EventEngine<Real>::handle(std::uint32_t ball, const BallEvent<Real>& event,
                               const ImpactRecord& record) {
    switch (event.kind) {
        case EventKind::cell_transfer:
            return transfer(ball, event.other);
        case EventKind::transition:
            for (const std::uint32_t each : transitions_.handle(ball))
                predict(each);
            return;
        case EventKind::ball_ball: {
            const bool is_void = event.other_version != balls_[event.other].version;
            return is_void ? predict(ball) : impact(ball, event, record);
        }
        default:
            return impact(ball, event, record);
    }
}

template <typename Real>
void EventEngine<Real>::transfer(std::uint32_t ball, std::uint32_t what) {
    if (what == cell_transfer::restart_in_frame) {
        transitions_.restart_in_frame(ball);
        return predict(ball);
    }
    predictor_.transfer(ball, what);
    schedule_.update(ball);
}

template <typename Real>
void EventEngine<Real>::impact(std::uint32_t ball, const BallEvent<Real>& event,
                               const ImpactRecord& record) {
    bool has_changed = false;
    for (const std::uint32_t each : response_.resolve(ball, event, record)) {
        has_changed = static_cast<int>(has_changed) | static_cast<int>(each == ball);
        const std::uint32_t body = cluster_.body_of(each);
        if (body != BallRecord<Real>::none && cluster_.has_neighbours(cluster_.bodies()[body]))
            predictor_.predict_among(each, cluster_.neighbours_of(cluster_.bodies()[body]));
        else
            predictor_.predict(each);
        schedule_.update(each);
    }
    cluster_.end();
    if (!has_changed) predict(ball);
}

template <typename Real>
void EventEngine<Real>::predict(std::uint32_t ball) {
    predictor_.predict(ball);
    schedule_.update(ball);
}

template <typename Real>
void EventEngine<Real>::predict_all() {
    for (std::uint32_t i = 0; i < balls_.size() && work_.may_go_on(); ++i)
        predictor_.predict(i);
    schedule_.rebuild();
}

// Time stands still for a ball that has used its share of the work.
template <typename Real>
void EventEngine<Real>::charge(std::uint32_t ball, const BallEvent<Real>& event) {
    const std::uint64_t work = work_.take_uncharged();
    const auto charge_ball = [&](std::uint32_t each) {
        if (!work_.charge(each, work) || balls_[each].line.motion == Motion::held) return;
        standstill_.stop(each);
        predict(each);
    };
    charge_ball(ball);
    if (event.kind == EventKind::ball_ball) charge_ball(event.other);
}

template class EventEngine<double>;
template class EventEngine<DoubleDouble>;

}  // namespace carom
