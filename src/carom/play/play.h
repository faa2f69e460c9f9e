#pragma once

#include "carom/options/play_options.h"

/// Plays in a terminal: `carom`, the menu, and `carom play LEVEL`.
namespace carom {

/// Plays until the player quits or the terminal is gone. Returns the exit code: 0, or 2 when the
/// level cannot be loaded or the terminal cannot be used (the reason is then on standard error).
int play(const PlayOptions& options);

}  // namespace carom
