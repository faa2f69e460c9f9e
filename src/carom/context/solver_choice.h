#pragma once

#include <string>

#include "level/scene/scene.h"
#include "physics/solver.h"

/// Solvers as the player chooses and reads them.
namespace carom {

/// The solver of this kind with the level's settings, where the level names it, else with defaults.
SolverSettings settings_of(SolverKind kind, const Scene& scene);

/// "swept", "substep 4x15": a solver with those of its settings that are not the default.
std::string solver_text(const SolverSettings& settings);

/// The next kind in the order of solvers_available() that supports the model, round and round.
SolverKind next_solver_kind(SolverKind current, const Model& model);

}  // namespace carom
