#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom check`: prints all problems of each level on standard error, and a line on standard
/// output for each level that loads. Returns the exit code: 0, or 2 when a level has an error.
int check(const CheckOptions& options);

/// `carom list`: prints name and title of the levels that ship on standard output. Returns the exit
/// code.
int list(const ListOptions& options);

}  // namespace carom
