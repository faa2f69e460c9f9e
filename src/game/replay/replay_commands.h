#pragma once

#include <optional>
#include <string>

#include "game/commands/command.h"
#include "game/pool/shot_setup.h"
#include "game/replay/replay_words.h"
#include "physics/solver.h"

/// Commands, solvers and shot setups in the syntax of replays: see replay_text.h.
namespace carom {

std::string replay_text(const Command& command);
std::string replay_text(const ShotSetup& setup);

/// None: there is no such command. Invalid numbers make `words` fail.
std::optional<Command> read_command(Words& words);
/// Invalid settings make `words` fail; those that are absent have their usual values.
SolverSettings read_solver(Words& words);
ShotSetup read_shot_setup(Words& words);

}  // namespace carom
