#include "carom/controllers/world_control.h"

#include <fmt/format.h>

#include <optional>

#include "carom/context/solver_choice.h"

namespace carom {
namespace {

/// Default gravity for a scene without: a fall through the view takes about a second and a half.
Vec2 gentle_gravity(const Scene& scene) {
    if (scene.unit != LengthUnit::natural && size(scene.view).y > 1.0) return {0.0, -9.81};
    return {0.0, -size(scene.view).y};
}

/// The present gravity, or the gravity that toggling would turn on.
Vec2 gravity_when_on(PlayContext& play) {
    const Scene& scene = play.session.scene();
    const std::optional<Vec2>& gravity = play.session.world().model().gravity;
    if (gravity) play.last_gravity = gravity;
    return play.last_gravity.value_or(scene.world.model().gravity.value_or(gentle_gravity(scene)));
}

void set_gravity(PlayContext& play, std::optional<Vec2> gravity) {
    // Turns -0 into 0 for display.
    if (gravity) *gravity += Vec2{0.0, 0.0};
    obey(play, command::SetGravity{gravity},
         gravity ? fmt::format("gravity {:.3g},{:.3g}", gravity->x, gravity->y) : "gravity off");
}

}  // namespace

void next_solver(PlayContext& play) {
    const SolverKind next =
        next_solver_kind(play.session.solver().kind, play.session.world().model());
    const SolverSettings settings = settings_of(next, play.session.scene());
    play.solver_is_picked = false;
    obey(play, command::SetSolver{settings}, "solver " + solver_text(settings));
}

void toggle_gravity(PlayContext& play) {
    const Vec2 on = gravity_when_on(play);
    const bool is_on = play.session.world().model().gravity.has_value();
    set_gravity(play, is_on ? std::nullopt : std::optional(on));
}

void turn_gravity(PlayContext& play) {
    set_gravity(play, perpendicular(gravity_when_on(play)));
}

}  // namespace carom
