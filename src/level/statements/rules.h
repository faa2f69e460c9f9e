#pragma once

#include "level/ir/arguments.h"

/// What a level says of its game: `on ...` and `game pinball ...`. Names are looked up later
/// (table_assembly.h).
namespace carom {

/// Pre, for both: arguments.is_valid.
void declare_rule(const Arguments& arguments, const Scope& scope, Context& context);
void declare_pinball(const Arguments& arguments, Context& context);

}  // namespace carom
