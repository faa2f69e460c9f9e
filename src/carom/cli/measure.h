#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom measure`: prints cost against error, or writes it to files. Returns the exit code: 0, or
/// 2 for a bad level or an output that cannot be written. INT, TERM and HUP end it after the
/// current tick: complete results are written, and then the process dies of the signal.
int measure(const MeasureOptions& options);

}  // namespace carom
