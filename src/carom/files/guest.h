#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "carom/files/files.h"
#include "carom/options/guest_options.h"

/// Guests: many people who play on one account, each in a folder of its own,
/// `~/.local/share/carom/guests/NAME`. It holds the levels that the guest saves (`levels`, the
/// working folder), preferences, high scores and unfinished games.
namespace carom {

/// Turns this process into the guest's: its folder is made, the environment names it, and on Linux
/// with Landlock the system allows no file elsewhere to be written, and only levels that ship and
/// what terminals and locales need to be read. A file may have at most 16 MiB. Variables that name
/// other folders are ignored, since a client may have set them.
///
/// Returns the lock of this session, to be held as long as the guest plays, or an error for people:
/// the folder cannot be made, or the guest plays in too many sessions already.
std::variant<FileLock, std::string> become_guest(const GuestOptions& guest);

/// Removes the oldest files of the folder with this extension, such as ".level", until `most` are
/// left. Returns the name of the last one that was removed, if any.
std::optional<std::string> remove_oldest(const std::string& folder, std::string_view extension,
                                         std::size_t most);

}  // namespace carom
