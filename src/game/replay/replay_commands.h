#pragma once

#include <optional>
#include <string>

#include "game/commands/command.h"
#include "game/pool/shot_setup.h"
#include "game/replay/replay_words.h"
#include "physics/solver.h"

/// Commands, solvers and stances as a replay says them: see replay_text.h.
namespace carom {

std::string replay_text(const Command& command);
std::string replay_text(const ShotSetup& stance);

/// None: there is no such command. Wrong numbers make `words` fail.
std::optional<Command> read_command(Words& words);
/// What is wrong makes `words` fail.
SolverSettings read_solver(Words& words);
ShotSetup read_shot_setup(Words& words);

}  // namespace carom
