#pragma once

#include <string>

#include "carom/files/level_files.h"

namespace carom {

/// Loads a level as load_level_file() does, and prints its error or its diagnostics to standard
/// error.
LoadedLevel load_and_report(const std::string& level, const LoadOptions& options);

}  // namespace carom
