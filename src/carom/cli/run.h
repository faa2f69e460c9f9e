#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom run`: simulates without a screen and writes what was asked for; a few lines for people
/// when nothing was. Returns the exit code: 0; 1 when an `expect` of the level fails; 2 for a bad
/// level or an output that cannot be written. INT, TERM and HUP end the run after the tick that it
/// is in: the outputs are complete up to there, and then the process dies of the signal.
int run(const RunOptions& options);

}  // namespace carom
