#pragma once

#include "level/assemble/futile_rules.h"
#include "level/ir/context.h"
#include "level/scene/rules.h"

/// Words in rules that are no error, but mean nothing where they stand: `once` where nothing meets,
/// pockets as places for balls, numbers of another game.
namespace carom {

/// Reports them as warnings. Pre: as for warn_of_futile_rules().
void warn_of_idle_words(const RuleBook& book, const RuleFacts& facts, Context& context);

}  // namespace carom
