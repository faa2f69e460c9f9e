#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/replay_text.h"

/// Games that were cut off, so that they can be taken up where they stood. Each running game writes
/// a file of its own (its name holds the level's, a hash of its path, and the number of the
/// process), again every few seconds and when it is cut off; a game that ends in good order takes
/// its file away. What is left belongs to games that were cut off.
namespace carom {

struct CutOffGame {
    std::string file;
    Replay replay;
    std::int64_t saved = 0;  ///< s since 1970
};

/// Those of processes that run no more, the newest first; files that cannot be read are left out.
/// `level`: the path of one level only, as it is in Replay::level; empty: of all.
std::vector<CutOffGame> cut_off_games(const std::string& folder, std::string_view level = {});

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

  private:
    std::string folder_;
    std::string path_;  ///< empty: there is no place to write to
    bool is_written_ = false;
};

/// Takes a cut-off game's file away: it has been taken up, or is not wanted.
void forget(const CutOffGame& game);

/// Where they are, by the user's folders; none: the user has no such place.
std::optional<std::string> resume_folder();

}  // namespace carom
