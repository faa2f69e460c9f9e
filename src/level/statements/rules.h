#pragma once

#include "level/ir/arguments.h"

namespace carom {

/// Executes `on NAME ...`: adds a pinball rule to the intermediate representation. Reports words
/// that do not form a rule; its names are resolved later (assemble/pinball_assembly.h).
void add_rule(const Arguments& arguments, const Frame& frame, Context& context);

}  // namespace carom
