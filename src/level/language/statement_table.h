#pragma once

#include <vector>

#include "level/language/statements.h"

namespace carom {

/// The rows of the table of statements, in the order of the manual: to be made once, and looked up
/// with the functions of statements.h.
std::vector<Statement> make_statements();

}  // namespace carom
