#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom compare`: runs a level under two solvers and reports when they diverge. Returns the exit
/// code: 0 when they do not diverge, 1 when they do, 2 for a bad level or an output that cannot be
/// written. INT, TERM and HUP end it: it writes its results so far, and the process dies of the
/// signal.
int compare(const CompareOptions& options);

}  // namespace carom
