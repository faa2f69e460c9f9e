#pragma once

#include "level/ir/arguments.h"

namespace carom {

/// Carries out `on NAME ...`: adds a pinball rule to the intermediate representation. Reports words
/// that are no rule; the names in it are looked up later (assemble/pinball_assembly.h).
void add_rule(const Arguments& arguments, const Frame& frame, Context& context);

}  // namespace carom
