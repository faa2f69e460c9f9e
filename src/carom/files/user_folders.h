#pragma once

#include <optional>
#include <string>

/// The user's folders, by the XDG rules. Absolute paths; none if neither the variable nor HOME is
/// one.
namespace carom {

std::optional<std::string> configuration_folder();  ///< $XDG_CONFIG_HOME or ~/.config, /carom
std::optional<std::string> data_folder();           ///< $XDG_DATA_HOME or ~/.local/share, /carom
std::optional<std::string> state_folder();          ///< $XDG_STATE_HOME or ~/.local/state, /carom

/// Why there are none: "HOME is not set", or that it is no absolute path.
std::string no_folder_reason();

/// Makes the folder and its parents, private to the user. Returns the error, if any.
std::optional<std::string> make_folder(const std::string& path);

}  // namespace carom
