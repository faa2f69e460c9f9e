#include <fmt/format.h>

#include <algorithm>

#include "carom/play/player.h"

/// Keys that change the laws of the world: solver and gravity.
namespace carom {
namespace {

SolverKind after(SolverKind current, const Model& model) {
    const auto all = solvers_available();
    auto place = std::ranges::find(all, current);
    do
        place = place == all.end() || ++place == all.end() ? all.begin() : place;
    while (!supports(*place, model));
    return *place;
}

/// Gravity for a scene that has none: a fall through the view takes about a second and a half.
Vec2 gentle_gravity(const Scene& scene) {
    if (scene.unit != LengthUnit::natural && size(scene.view).y > 1.0) return {0.0, -9.81};
    return {0.0, -size(scene.view).y};
}

}  // namespace

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

void Player::perform_on_world(Action action) {
    const std::optional<Vec2>& gravity = session_.world().model.gravity;
    if (gravity) last_gravity_ = gravity;
    const Vec2 on = last_gravity_.value_or(
        session_.scene().world.model.gravity.value_or(gentle_gravity(session_.scene())));
    if (action == Action::solver) return next_solver();
    if (action == Action::turn_gravity) return set_gravity(perpendicular(on));
    set_gravity(gravity ? std::nullopt : std::optional<Vec2>(on));
}

void Player::set_gravity(std::optional<Vec2> gravity) {
    // -0 would be shown as such.
    if (gravity) *gravity += Vec2{0.0, 0.0};
    obey(command::SetGravity{gravity},
         gravity ? fmt::format("gravity {:.3g},{:.3g}", gravity->x, gravity->y) : "gravity off");
}

void Player::next_solver() {
    const SolverSettings settings =
        settings_of(after(session_.solver().kind, session_.world().model), session_.scene());
    solver_is_picked_ = false;
    obey(command::SetSolver{settings}, "solver " + solver_text(settings));
}

void Player::obey(const Command& command, std::string done) {
    if (const auto why_not = session_.apply(command)) {
        complain(*why_not);
        return;
    }
    set_reference();
    say(std::move(done));
}

}  // namespace carom
