#pragma once

#include <string>
#include <string_view>

#include "level/scene/scene.h"
#include "physics/solver.h"

/// How the player chooses a solver, and how its settings are displayed.
namespace carom {

/// The settings for this kind: the level's, if the level names this solver, else the defaults.
SolverSettings settings_of(SolverKind kind, const Scene& scene);

/// "swept", "substep 4x15": a solver with its non-default settings.
std::string solver_text(const SolverSettings& settings);

/// What a solver does in a tick, in at most 45 characters: "exact events, however many a tick".
std::string_view method_of(SolverKind kind);

/// The next kind that supports the model, in the cyclic order of solvers_available().
SolverKind next_solver_kind(SolverKind current, const Model& model);

}  // namespace carom
