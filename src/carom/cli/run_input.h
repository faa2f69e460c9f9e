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

/// Reads the input. Scene::solver becomes the requested solver: that of the options, else of the
/// recording, else of the level. Experiments are judged under a script, but not in a recording that
/// has commands. None: an error, which has been printed.
std::optional<RunInput> open_run_input(const RunOptions& options);

/// The message about a refused command, with its line in the script if it has one.
std::string told_refusal(const RunOptions& options, const RunInput& input,
                         const ScriptRunner::Refused& refused);

}  // namespace carom
