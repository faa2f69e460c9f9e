#include "carom/cli/compare.h"

#include <fmt/format.h>

#include <functional>
#include <optional>

#include "carom/cli/interrupt.h"
#include "carom/cli/load_and_report.h"
#include "carom/cli/progress.h"
#include "carom/files/files.h"
#include "carom/files/output_clash.h"
#include "carom/files/print.h"
#include "lab/compare/compare.h"
#include "lab/run/run_record.h"

namespace carom {
namespace {

// A solver of the kind that the level names runs with the level's settings.
Choice choice_of(const CompareOptions::Side& side, const Scene& scene) {
    const SolverSettings own = solver_for(scene);
    return {own.kind == side.kind ? own : SolverSettings{.kind = side.kind},
            side.rate.value_or(scene.world.rate())};
}

CompareSettings settings_of(const CompareOptions& options, const Scene& scene) {
    CompareSettings settings{.first = choice_of(options.solvers[0], scene),
                             .second = choice_of(options.solvers[1], scene),
                             .nudge = options.nudge.value_or(0.0)};
    if (options.time) settings.time = *options.time;
    if (options.tolerance) settings.tolerance = *options.tolerance;
    return settings;
}

Comparison compare_with_bar(const Scene& scene, const CompareSettings& settings) {
    ProgressOrSignal go_on;
    return compare(scene, settings, std::ref(go_on));
}

int compare_scene(const CompareOptions& options, const Scene& scene) {
    for (const CompareOptions::Side& side : options.solvers) {
        if (supports(side.kind, scene.world.model())) continue;
        print_error(fmt::format("solver {} does not know {}", name(side.kind),
                                scene.world.model().hinged ? "seesaws" : "cloth"));
        return 2;
    }
    if (const auto why = clash_of_outputs({&options.json, 1}, scene.files)) {
        print_error(*why);
        return 2;
    }
    std::optional<OutputFile> json;
    if (!options.json.empty()) json.emplace(options.json);
    if (json && !json->error().empty()) {
        print_error(json->error());
        return 2;
    }
    const InterruptGuard guard;
    const Comparison comparison = compare_with_bar(scene, settings_of(options, scene));
    if (json) {
        json->write(compare_json(options.level, scene, comparison));
        json->commit();
        if (!json->error().empty()) {
            print_error(json->error());
            return 2;
        }
    }
    if (options.json != "-" && !print_out(compare_text(scene, comparison))) return 2;
    return comparison.divergence ? 1 : 0;
}

}  // namespace

int compare(const CompareOptions& options) {
    const LoadedLevel level = load_and_report(
        options.level,
        {.overrides = options.overrides, .seed = options.seed, .rate = options.rate});
    if (!level.result.scene) return 2;
    const int code = compare_scene(options, *level.result.scene);
    if (const int signal = InterruptGuard::signal()) die_of(signal);
    return code;
}

}  // namespace carom
