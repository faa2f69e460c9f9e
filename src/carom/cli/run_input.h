#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "carom/options/options.h"
#include "game/replay/command_script.h"
#include "game/replay/replay_text.h"
#include "level/scene/scene.h"

namespace carom {

/// What a run starts with: a level, perhaps with a script of commands, or a recording.
struct RunInput {
    Scene scene;
    CommandScript script;
    std::string script_text;          ///< of --commands, for messages; empty without
    std::optional<Replay> recording;  ///< none: a level
    std::uint64_t ticks = 0;          ///< to run
};

/// Reads it. Scene::solver is the one that is asked for: by the options, else by the recording,
/// else by the level. Experiments are judged under a script, but not in a recording that has
/// commands. None: an error, which has been printed.
std::optional<RunInput> open_run_input(const RunOptions& options);

/// What a command that is refused gets as its message: with its line in the script, if it has one.
std::string told_refusal(const RunOptions& options, const RunInput& input,
                         const ScriptRunner::Refused& refused);

}  // namespace carom
