#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom check`: everything that is wrong with each level, on standard error, and a line on
/// standard output for each level that loads. Returns the exit code: 0, or 2 when some level has an
/// error.
int check(const CheckOptions& options);

/// `carom list`: the levels that ship, name and title, on standard output. Returns the exit code.
int list(const ListOptions& options);

}  // namespace carom
