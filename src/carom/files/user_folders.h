#pragma once

#include <optional>
#include <string>

/// Where a user's files are, by the XDG rules. Absolute paths; none where neither the variable nor
/// HOME says anything.
namespace carom {

std::optional<std::string> configuration_folder();  ///< $XDG_CONFIG_HOME or ~/.config, /carom
std::optional<std::string> data_folder();           ///< $XDG_DATA_HOME or ~/.local/share, /carom
std::optional<std::string> state_folder();          ///< $XDG_STATE_HOME or ~/.local/state, /carom

/// Makes the folder, and those above it, for the user alone. What went wrong, if anything.
std::optional<std::string> make_folder(const std::string& path);

}  // namespace carom
