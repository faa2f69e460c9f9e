#include "carom/context/solver_choice.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {

SolverSettings settings_of(SolverKind kind, const Scene& scene) {
    if (scene.solver && scene.solver->kind == kind) return *scene.solver;
    SolverSettings settings;
    settings.kind = kind;
    return settings;
}

std::string solver_text(const SolverSettings& settings) {
    const std::string name_text{name(settings.kind)};
    if (settings.kind == SolverKind::substep)
        return fmt::format("{} {}x{}", name_text, settings.updates, settings.steps);
    if (substeps_of(settings) != substeps_of({.kind = settings.kind}))
        return fmt::format("{} {}", name_text, substeps_of(settings));
    return name_text;
}

std::string_view method_of(SolverKind kind) {
    switch (kind) {
        case SolverKind::discrete:
            return "moves all, then parts what overlaps";
        case SolverKind::substep:
            return "moves and parts overlaps in small steps";
        case SolverKind::swept:
            return "first impact on straight paths, then the next";
        case SolverKind::contact:
            return "four small steps, contacts as stiff springs";
        case SolverKind::event:
            return "exact impacts, one after another";
    }
    return {};
}

SolverKind next_solver_kind(SolverKind current, const Model& model) {
    const auto all = solvers_available();
    auto place = std::ranges::find(all, current);
    do
        place = place == all.end() || ++place == all.end() ? all.begin() : place;
    while (!supports(*place, model));
    return *place;
}

}  // namespace carom
