#pragma once

#include <optional>
#include <string>
#include <vector>

/// The recordings that a player keeps from play: NAME.replay in the folder `recordings` of carom's
/// data folder, so the menu finds them wherever carom is started.
namespace carom {

struct KeptRecording {
    std::string name;  ///< the file name without folder and `.replay`
    std::string path;
    std::string level;                ///< its name, without `.level`; empty: not a sound recording
    std::optional<double> seconds{};  ///< its length; none: not a sound recording
};

/// None: the user has no such folder.
std::optional<std::string> recordings_folder();
/// Where a recording of this name is kept. Pre: there is a folder.
std::string recording_path(const std::string& name);
/// The newest first. Files that do not begin as a recording does are left out.
std::vector<KeptRecording> kept_recordings();
/// A name for a recording of the level that is still free: "eight-ball-2".
std::string free_recording_name(const std::string& level);

}  // namespace carom
