#include "lab/run/run_record.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr std::string_view overridden = "the level was changed from outside";
constexpr std::string_view not_reached = "the run ended before its time";

void judge_due(RunRecord& record, const Scene& scene, const World& world) {
    if (scene.overridden) return;
    for (std::size_t i = 0; i < scene.expects.size(); ++i) {
        const std::optional<double> at = scene.expects[i].at;
        if (!at || std::round(*at * world.rate()) != static_cast<double>(world.tick())) continue;
        record.judgements[i] = judge(scene.expects[i], world, record.watch);
    }
}

}  // namespace

RunRecord begin_record(const Scene& scene, const SolverSettings& solver) {
    RunRecord record{.solver = solver,
                     .totals_start = totals(scene.world),
                     .watch = RunWatch(scene, RunWatch::Conservation::ignored),
                     .ball_ticks = 0,
                     .judgements = {}};
    const Judgement not_yet{.reason = scene.overridden ? overridden : not_reached};
    record.judgements.assign(scene.expects.size(), not_yet);
    judge_due(record, scene, scene.world);
    return record;
}

void note_tick(RunRecord& record, const Scene& scene, const World& world) {
    record.watch.note_tick(world);
    record.ball_ticks += world.balls().size();
    judge_due(record, scene, world);
}

void note_end(RunRecord& record, const Scene& scene, const World& world) {
    if (scene.overridden) return;
    for (std::size_t i = 0; i < scene.expects.size(); ++i) {
        if (scene.expects[i].at) continue;
        record.judgements[i] = judge(scene.expects[i], world, record.watch);
    }
}

bool has_failure(const RunRecord& record) {
    return std::ranges::find(record.judgements, Verdict::fails, &Judgement::verdict) !=
           record.judgements.end();
}

SolverSettings solver_for(const Scene& scene) {
    return scene.solver ? *scene.solver : pick_solver(scene.world).settings;
}

}  // namespace carom
