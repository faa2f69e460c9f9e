#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/replay/replay_text.h"

/// Unfinished games: those that were interrupted, or left in the middle, so that they can be
/// resumed. Each running game writes a file of its own (its name holds the level's, a hash of its
/// path, and the number of the process), again every few seconds and when it is interrupted. A game
/// that ends in good order removes its file; one that is left to be resumed puts it aside under a
/// name without a process. A file that belongs to no running process can be resumed.
namespace carom {

struct InterruptedGame {
    std::string file;
    Replay replay;
    std::int64_t saved = 0;  ///< s since 1970
    bool was_left = false;   ///< by the player, to be resumed
};

/// The unfinished games of no running process, the newest first; files that cannot be read are left
/// out. `level`: the path of one level only, as it is in Replay::level; empty: of all.
std::vector<InterruptedGame> interrupted_games(const std::string& folder,
                                               std::string_view level = {});

/// The file of one running game. It stays when this goes: only remove() takes it away.
class ResumeFile {
  public:
    ResumeFile() = default;
    /// In this folder, which is made when it is first needed.
    ResumeFile(std::string folder, std::string_view level);

    /// What went wrong, if anything. At most 20 files stay in the folder: the oldest go.
    std::optional<std::string> save(const Replay& replay);
    /// The game has ended in good order.
    void remove();
    /// The game is left as it was saved last, to be resumed. False: nothing was saved.
    bool put_aside();

  private:
    std::string folder_;
    std::string path_;  ///< empty: there is no place to write to
    bool is_written_ = false;
};

/// Removes the game's file: it has been resumed, or is not wanted.
void forget(const InterruptedGame& game);

/// The folder of unfinished games; none: the user has no such place.
std::optional<std::string> resume_folder();

}  // namespace carom
