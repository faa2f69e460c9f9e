#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bits/level_writer.h"
#include "game/replay/replay_text.h"
#include "lab/run/invariants.h"
#include "level/scene/scene.h"

/// Random scenes that use every term, every material constant, hands and flippers (tests/bits),
/// run as under `carom run --check`.
namespace carom::test {

struct FuzzedScene {
    std::string text;  ///< the level
    std::uint64_t ticks = 0;
    std::optional<Scene> scene;        ///< none: the level does not load
    std::vector<TimedCommand> script;  ///< what a player does; the game may refuse some of it
};

/// The scene of this number, the same with every compiler and on every machine.
/// `least_decade`: see bits::write_level.
FuzzedScene fuzzed_scene(std::uint64_t number, double least_decade = bits::usual_least_decade);

/// A level and a script of commands, as a scene to be run for `ticks`.
FuzzedScene scene_of(std::string level, const std::string& commands, std::uint64_t ticks);

/// What one run under one solver came to.
struct CheckedRun {
    std::optional<Breach> breach;  ///< that ended it
    bool stood_still = false;      ///< a budget was reached in some tick
    std::uint64_t ticks = 0;
    std::string commands;  ///< those that the game did not refuse, as a script
};
/// Pre: the scene has loaded, and the solver supports its model.
CheckedRun check_run(const FuzzedScene& fuzzed, SolverKind solver);

}  // namespace carom::test
