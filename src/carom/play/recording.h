#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "game/replay/replay_text.h"
#include "game/session/session.h"
#include "level/scene/scene.h"

/// Replays as files: `--record`, `carom replay`, `carom verify`.
namespace carom {

struct OpenedReplay {
    Replay replay;
    Scene scene;
};

/// Reads a replay, loads the level in it, and looks whether this carom has its solver. Else the
/// errors, as people read them: with file, line and remedy, and a line end.
std::variant<OpenedReplay, std::string> open_replay(const std::string& path);

/// A recording that is being made. The file appears under its name only when it is written whole;
/// what stood there before stays until then.
class Recording {
  public:
    explicit Recording(std::string path) : path_(std::move(path)) {}

    const std::string& path() const { return path_; }
    /// Why nothing could be written there, so that a player learns of it before the game.
    std::optional<std::string> obstacle() const;
    /// The session so far. `level`: the path of its file. What went wrong, if anything.
    std::optional<std::string> write(const Session& session, const std::string& level,
                                     std::span<const std::string> overrides) const;

  private:
    std::string path_;
};

/// What a level is called in a recording: its file's name, since the folders are the player's own.
std::string name_in_recording(const std::string& level);

}  // namespace carom
