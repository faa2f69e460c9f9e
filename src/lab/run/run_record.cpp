#include "lab/run/run_record.h"

#include <fmt/format.h>

#include <algorithm>

#include "lab/run/invariants.h"

namespace carom {
namespace {

constexpr std::string_view overridden = "the level was changed from outside";
constexpr std::string_view not_reached = "the run ended before its time";

void judge_all(RunRecord& record, const Scene& scene, const World& world, bool is_last) {
    if (scene.overridden) return;
    for (std::size_t i = 0; i < scene.expects.size(); ++i)
        judge(scene.expects[i], world, record.watch, is_last, record.judgements[i]);
}

void note_not_held(RunRecord& record, const World& world) {
    const std::size_t balls = count_too_small(promise_of(record.solver.kind), world);
    if (balls == 0) return;
    NotHeld& noted = record.not_held;
    if (++noted.ticks == 1) noted.first_tick = world.tick();
    noted.most_balls = std::max(noted.most_balls, balls);
}

}  // namespace

RunRecord begin_record(const Scene& scene, const SolverSettings& solver) {
    RunRecord record{.solver = solver,
                     .totals_start = totals(scene.world),
                     .watch = RunWatch(scene, RunWatch::Conservation::ignored),
                     .stood_still = {},
                     .not_held = {},
                     .ignores_modulus = scene.world.model().modulus.has_value() &&
                                        solver.kind != SolverKind::event,
                     .ball_ticks = 0,
                     .judgements = {}};
    record.watch.observe(scene, solver);
    const Judgement not_yet{.reason = scene.overridden ? overridden : not_reached};
    record.judgements.assign(scene.expects.size(), not_yet);
    judge_all(record, scene, scene.world, false);
    return record;
}

void note_tick(RunRecord& record, const Scene& scene, const World& world,
               std::span<const Contact> contacts) {
    record.watch.note_tick(world);
    record.watch.observe_tick(scene, world, contacts);
    record.ball_ticks += world.balls().size();
    note_not_held(record, world);
    judge_all(record, scene, world, false);
}

void note_standing(RunRecord& record, const World& world, std::size_t balls) {
    if (balls == 0) return;
    StoodStill& noted = record.stood_still;
    if (++noted.ticks == 1) {
        noted.first_tick = world.tick();
        noted.balls = balls;
    }
    noted.most_balls = std::max(noted.most_balls, balls);
}

std::string notes_text(const RunRecord& record, double rate) {
    std::string text;
    if (record.ignores_modulus)
        text = fmt::format(
            "note: under {} impacts take no time, although the level says use modulus: only event "
            "knows it.\n",
            name(record.solver.kind));
    if (record.actions_left_out > 0)
        text += fmt::format(
            "note: the rules ask for more than {} actions in a tick, first in tick {}: {} were "
            "left "
            "out.\n",
            most_actions_in_a_tick, record.first_left_out, record.actions_left_out);
    const NotHeld& small = record.not_held;
    if (small.ticks > 0)
        text += fmt::format(
            "note: gravity moves small balls too far in a tick for {}, in {} tick{}, first in tick "
            "{}, at most {} ball{} in one tick: they may sink into others, and gain energy. More "
            "ticks a second help.\n",
            name(record.solver.kind), small.ticks, small.ticks == 1 ? "" : "s", small.first_tick,
            small.most_balls, small.most_balls == 1 ? "" : "s");
    const StoodStill& noted = record.stood_still;
    if (noted.ticks == 0) return text;
    return text +
           fmt::format(
               "note: time stood still in {} tick{}, first in tick {} ({:.6g} s) for {} "
               "ball{}, for "
               "at most {} in one tick: beyond what the solver does in a tick. Their energy is "
               "unchanged.\n",
               noted.ticks, noted.ticks == 1 ? "" : "s", noted.first_tick,
               static_cast<double>(noted.first_tick) / rate, noted.balls,
               noted.balls == 1 ? "" : "s", noted.most_balls);
}

void note_end(RunRecord& record, const Scene& scene, const World& world) {
    judge_all(record, scene, world, true);
}

bool has_failure(const RunRecord& record) {
    return std::ranges::find(record.judgements, Verdict::fails, &Judgement::verdict) !=
           record.judgements.end();
}

SolverSettings solver_for(const Scene& scene) {
    return scene.solver ? *scene.solver : pick_solver(scene.world).settings;
}

}  // namespace carom
