#pragma once

#include <string>
#include <vector>

/// What the system forbids this process and its children, for good.
namespace carom {

/// Confines all later opening of files: reading to `readable`, reading and writing to `writable`,
/// each a folder with all that is below it. Nothing can be executed, and a set-user-id program
/// gains nothing. Folders that do not exist are left out. Files that are open stay open.
///
/// False: the system cannot do that (it takes Linux 5.13 with Landlock), and nothing has changed.
///
/// Pre: no other thread runs.
bool confine_files(const std::vector<std::string>& readable,
                   const std::vector<std::string>& writable);

}  // namespace carom
