#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom new FILE`: writes a level to begin with, or a copy of another level. An existing file
/// stays. Returns the exit code: 0, or 2 after an error.
int new_level(const NewOptions& options);

}  // namespace carom
