#pragma once

#include <span>
#include <string_view>

#include "level/statements/action_shapes.h"

/// The table of the events that rules wait for. The reader (rules.cpp), messages and `carom explain
/// on` use it.
namespace carom {

struct EventWord {
    std::string_view name;
    RuleEvent event;           ///< refined when the subject is known (assemble/rule_assembly.h)
    std::string_view subject;  ///< the only subject that has this event; empty: a name of the level
    bool takes_other;          ///< a second name may follow
    RuleGames games;
    std::string_view form;  ///< as in a rule, without `on`
    std::string_view when;  ///< it happens, in one line
};

/// A word or a form of the rules, and what it means, in one line.
struct RuleForm {
    std::string_view name;
    std::string_view meaning;
};

/// What may stand between the event and the actions: `once` and the words that begin conditions.
std::span<const RuleForm> rule_filters();
/// Whether conditions begin with this word: if, while, unless.
bool begins_clause(std::string_view word);
/// What a condition may be.
std::span<const RuleForm> condition_forms();
/// The functions of values: count(BALLS) ...
std::span<const RuleForm> rule_functions();

/// One row for each event but the end of a timer.
std::span<const EventWord> event_words();

}  // namespace carom
