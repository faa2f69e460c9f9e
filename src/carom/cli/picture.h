#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom picture`: plays a level without a screen and writes what the screen would show. Returns
/// the exit code: 0, or 2 for a bad level or an output that cannot be written.
int picture(const PictureOptions& options);

}  // namespace carom
