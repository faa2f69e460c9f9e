#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "level/ir/context.h"
#include "level/statements/action_shapes.h"

/// Advice for what authors write in rules out of habit from other languages: `==`, `else`, `not`,
/// `made = 1`, a condition behind the action.
namespace carom {

struct RuleAdvice {
    std::string message;
    std::string remedy;
};

/// Where a condition is expected, or the word behind a condition. None: the word has no such habit.
std::optional<RuleAdvice> advice_on_condition(std::string_view word);

/// A value that cannot be read.
RuleAdvice advice_on_value(std::string_view text);

/// A subject and an event that do not go together, such as `patience ends` without a timer of this
/// name. None: only the event is unknown.
std::optional<RuleAdvice> advice_on_event(std::string_view subject, std::string_view event,
                                          const Context& context);

/// An action that is not known. None: it resembles nothing.
std::optional<RuleAdvice> advice_on_action(std::span<const Word> words, const Context& context);

/// Whether an unknown action has the form `total +1` or `total 3`, which sets a variable.
bool looks_like_variable(std::span<const Word> action);

/// An action with words too many.
RuleAdvice advice_on_extra_word(std::span<const Word> words, const ActionShape& shape,
                                const Context& context);

}  // namespace carom
