#include "physics/swept/solver.h"

#include "physics/swept/division.h"
#include "physics/swept/tolerances.h"
#include "physics/tick/emitters_and_sinks.h"

namespace carom {

void SweptSolver::tick(World& world, int substeps, std::vector<Contact>& contacts,
                       std::vector<std::uint8_t>& touched, CancellationToken& token,
                       bool is_repeated) {
    const SweptDivision division = divide_tick(world, substeps_needed(world, substeps));
    const int count = division.substeps + (division.rest > 0.0 ? 1 : 0);
    const double start = world.time();
    step_ = swept_substep(world, division.duration);
    paths_.begin_tick(world);
    budget_.begin(world.balls().size(), swept_tolerance::budget, is_repeated);
    for (int i = 0; i < count; ++i) {
        const bool is_rest = i == division.substeps;
        if (is_rest) step_ = swept_substep(world, division.rest);
        step_.start_time = start + division.duration * i;
        const double share_of_displacement =
            is_rest || division.rest == 0.0
                ? 1.0 / (count - i)
                : division.duration / (world.tick_length() - division.duration * i);
        paths_.begin(world, share_of_displacement);
        if (is_rest) paths_.stop_far_balls(world);
        kinematics_.begin(world, share_of_displacement / step_.duration);
        if (!token.may_continue(world.balls().size())) return;
        budget_.begin_part(static_cast<std::uint64_t>(count));
        resolve_impacts(world, contacts, touched, token);
        if (token.is_cancelled()) return;
        paths_.finish(world);
        kinematics_.finish(world, step_.duration);
    }
}

void SweptSolver::resolve_impacts(World& world, std::vector<Contact>& contacts,
                                  std::vector<std::uint8_t>& touched, CancellationToken& token) {
    candidates_.find(world);
    schedule_.clear();
    prediction_.predict_at_start(world);
    prediction_.take_tests();
    std::uint64_t work = 0;
    while (token.may_continue(work)) {
        const std::optional<SweptEvent> event = schedule_.take();
        const double stop = kinematics_.first_stop();
        if (stop < step_.duration && (!event || stop <= event->time)) {
            kinematics_.bounce_at_stops(stop);
            schedule_.clear();
            prediction_.predict_all(world, stop);
            work = swept_tolerance::work_of_impact;
            continue;
        }
        if (!event) break;
        work = swept_tolerance::work_of_impact;
        prediction_.prefetch(world);
        if (event->ball_version != paths_[event->ball].version) continue;
        if (prediction_.is_void(*event)) {
            prediction_.predict(world, event->ball, event->time);
            work = charge(world, *event);
            continue;
        }
        const SweptOutcome outcome = response_.collide(world, *event);
        touched[event->ball] = 1;
        if (event->kind == ContactKind::ball_ball) touched[event->other] = 1;
        if (outcome.contact) {
            contacts.push_back(*outcome.contact);
            contacts.back().time += step_.start_time;
        }
        predict_after(world, *event, outcome.has_changed_edge);
        work = charge(world, *event);
    }
}

void SweptSolver::predict_after(const World& world, const SweptEvent& event,
                                bool has_changed_edge) {
    if (has_changed_edge) {
        schedule_.clear();
        prediction_.predict_all(world, event.time);
        return;
    }
    candidates_.merge_if_many_changed(world);
    prediction_.predict(world, event.ball, event.time);
    if (event.kind == ContactKind::ball_ball) prediction_.predict(world, event.other, event.time);
}

// Time stands still for a ball that has used its share of the work. Returns the work of the event.
std::uint64_t SweptSolver::charge(World& world, const SweptEvent& event) {
    const std::uint64_t work = prediction_.take_tests() + swept_tolerance::work_of_impact;
    if (!budget_.spend(work)) return work;
    const auto charge_ball = [&](std::uint32_t ball) {
        if (!budget_.charge(ball, work) || paths_[ball].is_frozen) return;
        paths_.stand_still(world, ball, event.time);
        const bool is_first = paths_.redirect(world, ball, event.time, {});
        candidates_.note_change(world, ball, event.time, is_first);
        prediction_.predict(world, ball, event.time);
    };
    charge_ball(event.ball);
    if (event.kind == ContactKind::ball_ball) charge_ball(event.other);
    return work;
}

}  // namespace carom
