#pragma once

#include <optional>
#include <span>

#include "level/ir/context.h"
#include "level/statements/action_shapes.h"
#include "level/statements/rule_words.h"

/// The actions of rules, one row each.
namespace carom {

/// Reads one action, without its comma, and adds it to the rule. False: an error, which is
/// reported. Pre: words is not empty.
bool read_rule_action(std::span<const Word> words, const Scope& scope, Context& context,
                      RuleWords& reader, RuleIr& rule);

/// Whether a word begins an action: the name of one, or of a variable.
bool begins_action(std::string_view word, const Context& context);

/// The games that know an action.
RuleGames games_of(RuleAction::What what);
std::string_view name_of(RuleAction::What what);

}  // namespace carom
