#pragma once

#include "level/language/statement_table.h"

namespace carom {

/// The table of all statements of the level language, in the order of the manual's grammar. Made
/// once, from the rows of the families (statements/families.h) and of the blocks.
const StatementTable& all_statements();

}  // namespace carom
