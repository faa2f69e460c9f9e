#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom run`: simulates without a screen and writes the requested outputs; without any, a short
/// summary. Returns the exit code: 0; 1 when an `expect` of the level fails; 2 for a bad level or
/// an output that cannot be written. INT, TERM and HUP end the run after the current tick: the
/// outputs are complete up to there, and then the process dies of the signal.
int run(const RunOptions& options);

}  // namespace carom
