#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "carom/files/level_files.h"
#include "carom/options/play_options.h"
#include "game/replay/replayer.h"
#include "game/session/session.h"

/// A level with all the options that change it, which can be opened again and again.
namespace carom {

struct LevelSource {
    std::string path;
    std::optional<SolverSettings> solver;
    std::optional<double> rate;
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;
    std::size_t rewind_bytes = Session::default_rewind_bytes;
    /// The game that is played was begun on another text of the level, and keeps it.
    bool is_earlier = false;
};

/// The level and options of the command line; `argument`: the level as the user names it.
LevelSource source_of(const PlayOptions& options, const std::string& argument);

/// The level of an unfinished game, as it was played.
LevelSource source_of(const Replay& replay, std::size_t rewind_bytes);

LoadedLevel load(const LevelSource& source);
/// The level of an unfinished game. If its file is gone or has changed, the one in the recording.
LoadedLevel load(const Replay& replay, std::size_t rewind_bytes);

/// The reasons why a level cannot be played, line by line.
using Problems = std::vector<std::string>;

/// Splits a text into lines.
Problems lines_of(std::string_view text);

/// The solver that computes the level: its own, else the one that carom picks.
SolverSettings solver_of(const Scene& scene);

struct OpenedGame {
    Session session;
    bool solver_is_picked = false;      ///< by carom, not by the level or the player
    std::vector<std::string> warnings;  ///< first lines only: "file:line:col: warning: ..."
};
std::variant<OpenedGame, Problems> open_game(const LevelSource& source);

/// The level of an unfinished game, ready to be replayed up to the point of interruption.
std::variant<Replayer, Problems> reopen_game(const Replay& replay, std::size_t rewind_bytes);

}  // namespace carom
