#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom explain [STATEMENT]`: prints a statement of the level language, or all that begin with
/// its word, with what each of its keys takes; without a statement, the whole grammar. Returns the
/// exit code: 0, or 2 when there is no such statement.
int explain(const ExplainOptions& options);

}  // namespace carom
