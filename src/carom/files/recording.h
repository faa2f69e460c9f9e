#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "carom/files/files.h"
#include "game/replay/replay_text.h"
#include "game/session/session.h"
#include "level/scene/scene.h"

/// Replays as files: `--record`, `carom replay`, `carom verify`.
namespace carom {

struct OpenedReplay {
    Replay replay;
    Scene scene;
};

/// Reads a replay, loads its level, and checks that this carom has its solver. On failure returns
/// the errors as shown to people: with file, line and remedy, and a line end.
std::variant<OpenedReplay, std::string> open_replay(const std::string& path);

/// Whether the file begins as a recording does. False: it does not, or cannot be read.
bool is_recording(const std::string& path);

/// An error in a recording or a script, as shown to people: with file, line and remedy.
std::string rendered(const std::string& path, std::string_view text, const ReplayError& error);

/// A recording in progress. The file appears under its name only when it is complete; until then an
/// existing file stays, and for good if it is to be kept (Existing::kept).
class Recording {
  public:
    explicit Recording(std::string path, Existing existing = Existing::replaced)
        : path_(std::move(path)), existing_(existing) {}

    const std::string& path() const { return path_; }
    /// The reason why nothing can be written there, for the player to learn before the game.
    std::optional<std::string> obstacle() const;
    /// Writes the session so far; `level`: the path of its file; `opponent`: Replay::opponent.
    /// Returns the error, if any.
    std::optional<std::string> write(const Session& session, const std::string& level,
                                     std::span<const std::string> overrides,
                                     int opponent = 0) const;

  private:
    std::string path_;
    Existing existing_;
};

/// The name of a level in a recording: its file name only, since folders are private to the player.
std::string name_in_recording(const std::string& level);

}  // namespace carom
