#include "lab/run/run_record.h"

#include <algorithm>

namespace carom {
namespace {

constexpr std::string_view overridden = "the level was changed from outside";
constexpr std::string_view not_reached = "the run ended before its time";

void judge_all(RunRecord& record, const Scene& scene, const World& world, bool is_last) {
    if (scene.overridden) return;
    for (std::size_t i = 0; i < scene.expects.size(); ++i)
        judge(scene.expects[i], world, record.watch, is_last, record.judgements[i]);
}

// A command at tick 0 changes the solver before the first one has done anything.
void note_solver(RunRecord& record, std::uint64_t ticks_before, const SolverSettings& settings) {
    if (ticks_before == 0) record.solver = settings;
    const SolverSettings& known =
        record.solver_changes.empty() ? record.solver : record.solver_changes.back().settings;
    if (settings != known)
        record.solver_changes.push_back({.tick = ticks_before, .settings = settings});
}

}  // namespace

RunRecord begin_record(const Scene& scene, const SolverSettings& solver) {
    RunRecord record{.solver = solver,
                     .solver_changes = {},
                     .totals_start = totals(scene.world),
                     .watch = RunWatch(scene, RunWatch::Conservation::ignored),
                     .notes = {},
                     .ball_ticks = 0,
                     .judgements = {}};
    record.watch.observe(scene, solver);
    const Judgement not_yet{.reason = scene.overridden ? overridden : not_reached};
    record.judgements.assign(scene.expects.size(), not_yet);
    judge_all(record, scene, scene.world, false);
    return record;
}

void note_tick(RunRecord& record, const Scene& scene, const World& world, const Solver& solver,
               const RuleState* rules) {
    note_solver(record, world.tick() - scene.world.tick() - 1, solver.settings());
    record.watch.note_tick(world);
    record.watch.observe_tick(scene, world, solver.contacts());
    record.ball_ticks += world.balls().size();
    const Standing standing = standing_in(solver);
    record.notes.add(notes_of_tick(world, solver.settings().kind, standing, rules), world.tick());
    judge_all(record, scene, world, false);
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
