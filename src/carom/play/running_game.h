#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "carom/files/level_source.h"
#include "carom/files/recording.h"
#include "carom/play/file_watcher.h"
#include "carom/play/key_prompt.h"
#include "carom/play/player.h"
#include "carom/play/resume.h"
#include "carom/play/save_prompt.h"
#include "physics/version.h"

/// A running game, with the files around it.
namespace carom {

struct RunningGame {
    LevelSource source;
    Player player;
    FileWatcher watch;
    ResumeFile resume_file;
    std::optional<InterruptedGame> offer{};  ///< the game that the action "take-up" would resume
    std::uint64_t saved_tick = 0;
    std::size_t saved_commands = 0;
    std::optional<ShotSetup> saved_setup{};
    std::vector<FingerprintMark> expected{};  ///< fingerprints of a watched recording
    std::size_t marks_compared = 0;
    std::optional<SavePrompt> prompt{};      ///< while the player is asked for a name
    std::optional<KeyPrompt> key_prompt{};   ///< while the player is asked for a key
    int stars = 0;                           ///< of the level's goal, kept so far in this game
    std::string entry{};                     ///< the challenge of the menu that it is; empty: none
    std::string stars_name{};                ///< under which they are kept; empty: the level's
    bool was_paused = false;                 ///< before the question
    double messages_faded = 0.0;             ///< the time up to which they have, s
    int recorded_physics = physics_version;  ///< physics version of a watched recording

    /// Writes the resume file, if the game has changed since it was last written. False: the file
    /// is not there, or is older than the game; after an error, the next call tries again.
    bool autosave();
    /// Saves the game unless there is nothing to resume: a table of pinball that nobody plays.
    void keep();
    bool is_saved() const;
    /// Ends the game normally. True: it is a match of pool that is not won, or a game of pinball
    /// that its player has begun, and it is kept.
    bool leave();
    /// Tells the player where a watched recording differs from the replay; of one that was made
    /// under another physics version, only that. The replay continues either way.
    void compare_marks();
    /// Asks for a name to save the level under; the game waits. Complains where it cannot be saved.
    void ask_for_name();
    /// Asks under which name to keep a recording of the game so far.
    void ask_for_recording_name();
    /// Answers the question. `most`: see save_level and keep_recording.
    void answer(const InputEvent& event, std::size_t most = unlimited);
    /// Saves the level in the current folder as NAME.level: in its author's words, with what has
    /// changed (game/session/amend_level.h), or, where that does not read back to the same bits,
    /// flat as NAME-flat.level. An existing file stays. `most`: levels that may be kept there; the
    /// oldest give way.
    void save_level(const SavePrompt::Answer& answer, std::size_t most = unlimited);
    /// Keeps the game, from its start to its latest tick, as a recording (kept_recordings.h). An
    /// existing one stays. `most`: recordings that may be kept; the oldest give way.
    void keep_recording(const std::string& name, std::size_t most = unlimited);
    /// Asks for a key to change; the game waits.
    void ask_for_key();
    /// Answers that question. The answer, once there is one, is for the caller to act on.
    std::optional<KeyPrompt::Changed> answer_key(const InputEvent& event, const KeyMap& keys);
    /// Adds what has been played at pool since the last call to the player's record. `all`: also of
    /// a match that goes on.
    void keep_pool_record(bool all);
    /// Keeps the stars of the level's goal, if they are more than before in this game.
    void keep_stars();
    static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

  private:
    void ask(SavePrompt question);
    void wait_for_answer(const std::string& question);
};

}  // namespace carom
