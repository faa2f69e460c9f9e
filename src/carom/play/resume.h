#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/files/files.h"
#include "game/replay/replay_text.h"

/// Unfinished games: games that were interrupted, or left in the middle, and can be resumed. Each
/// running game writes a file of its own, every few seconds and when it is interrupted. The file's
/// name holds the level's name, a hash of its path, and a number. A game that ends normally removes
/// its file; one that is left to be resumed renames it. While a game is played, its process holds a
/// lock beside the file (FileLock): a file without one can be resumed.
namespace carom {

struct InterruptedGame {
    std::string file;
    Replay replay;
    std::int64_t saved = 0;  ///< s since 1970
    bool was_left = false;   ///< left by the player, to be resumed
};

/// The unfinished games of no running process, the newest first; unreadable files are left out.
/// `level`: only games of this level, a path as in Replay::level; empty: all games.
std::vector<InterruptedGame> interrupted_games(const std::string& folder,
                                               std::string_view level = {});

/// What is wrong with the unfinished games of this level that cannot be read: "FILE, line N: why",
/// the newest first.
std::vector<std::string> unreadable_games(const std::string& folder, std::string_view level = {});

/// The file of one running game. The destructor keeps it: only remove() deletes it.
class ResumeFile {
  public:
    ResumeFile() = default;
    /// The folder is made when it is first needed.
    ResumeFile(std::string folder, std::string_view level);

    /// Writes the file and returns the error, if any. At most 20 files stay in the folder: the
    /// oldest are deleted.
    std::optional<std::string> save(const Replay& replay);
    /// The game has ended normally: deletes the file.
    void remove();
    /// Keeps the game as it was last saved, to be resumed. False: nothing was saved.
    bool put_aside();

  private:
    std::optional<std::string> begin();

    std::string folder_;  ///< empty: there is no folder to write to
    std::string stem_;
    std::string path_;  ///< as soon as there is a lock
    std::optional<FileLock> lock_;
    bool is_written_ = false;
};

/// Deletes the game's file: it has been resumed, or is not wanted.
void forget(const InterruptedGame& game);

/// The folder of unfinished games; none: the user has no such folder.
std::optional<std::string> resume_folder();

}  // namespace carom
