#pragma once

#include "level/ir/arguments.h"

/// The statements of the rules (scene/rules.h): they report words that do not form a rule. Names of
/// devices, balls and places are resolved later (assemble/rule_assembly.h).
namespace carom {

/// `on NAME EVENT ...`
void add_rule(const Arguments& arguments, const Frame& frame, Context& context);
/// `var NAME [of SCOPE] [start=N]`
void add_variable(const Arguments& arguments, const Frame& frame, Context& context);
/// `timer NAME TIME`
void add_timer(const Arguments& arguments, const Frame& frame, Context& context);
/// `task "TEXT" [if ...]`
void add_task(const Arguments& arguments, const Frame& frame, Context& context);
/// `goal "TEXT" [within N [N [N]] shots|seconds|of VALUE | with N [N [N]] of VALUE] if ...`
void add_goal(const Arguments& arguments, const Frame& frame, Context& context);

}  // namespace carom
