#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "carom/files/level_source.h"
#include "carom/play/file_watcher.h"
#include "carom/play/player.h"
#include "carom/play/recording.h"
#include "carom/play/resume.h"

/// A game that is being played, with the files around it.
namespace carom {

struct RunningGame {
    LevelSource source;
    Player player;
    FileWatcher watch;
    ResumeFile resume_file;
    std::optional<InterruptedGame> offer{};  ///< what the action "take-up" would resume
    std::uint64_t saved_tick = 0;
    std::size_t saved_commands = 0;
    std::optional<ShotSetup> saved_setup{};
    std::vector<FingerprintMark> expected{};  ///< of a recording that is watched
    std::size_t marks_compared = 0;

    /// Writes the resume file, where the game has changed since it was written last.
    void autosave();
    bool is_saved() const;
    /// The game ends in good order. True: it is a match of pool that is not won, and is kept.
    bool leave();
    /// Tells where a recording that is watched differs from what was recorded.
    void compare_marks();
    /// Saves the world as a level file in the current folder.
    void save_level();
};

}  // namespace carom
