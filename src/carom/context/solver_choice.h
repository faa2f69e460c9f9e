#pragma once

#include <string>

#include "level/scene/scene.h"
#include "physics/solver.h"

/// How the player chooses a solver, and how its settings are displayed.
namespace carom {

/// The settings for this kind: the level's, if the level names this solver, else the defaults.
SolverSettings settings_of(SolverKind kind, const Scene& scene);

/// "swept", "substep 4x15": a solver with its non-default settings.
std::string solver_text(const SolverSettings& settings);

/// The next kind that supports the model, in the cyclic order of solvers_available().
SolverKind next_solver_kind(SolverKind current, const Model& model);

}  // namespace carom
