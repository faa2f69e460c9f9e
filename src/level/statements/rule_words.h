#pragma once

#include <optional>
#include <vector>

#include "level/ir/context.h"
#include "level/statements/rule_habits.h"

/// The pieces of a rule: values, conditions and texts. Names of devices, balls and places are
/// appended to `names`, and their indices refer to it (RuleIr).
namespace carom {

/// Reads the pieces of one rule. No result: an error, which is reported.
class RuleWords {
  public:
    RuleWords(const Scope& scope, Context& context, std::vector<RuleNameIr>& names)
        : scope_(scope), context_(context), names_(names) {}

    /// A whole number, or arithmetic with the variables and quantities of the rules. `label` and
    /// `bound` are for a value that has none of them.
    std::optional<RuleValue> value(const Word& word, std::string_view label, Bound bound);

    /// The clauses from words[next] on, which may be none. `next` is then the first word behind
    /// them.
    std::optional<std::vector<RuleClause>> clauses(const std::vector<Word>& words,
                                                   std::size_t& next);

    /// A text in quotes, with values in braces.
    std::optional<RuleText> text(const Word& word, std::string_view sample);

    /// The index into `names` of this name.
    std::uint32_t name(const Word& word, RuleNameIr::Role role);

    /// The variable or timer of this name, which counts as read; null: there is none.
    const RuleSymbolIr* read_symbol(std::string_view name);

  private:
    struct Cursor;
    bool mentions_rules(std::string_view text) const;
    bool is_ball_above(std::string_view name) const;
    bool is_level_number(std::string_view text) const;
    bool knows_names(const Word& word);
    bool sum(Cursor& cursor, RuleValue& out);
    bool product(Cursor& cursor, RuleValue& out);
    bool atom(Cursor& cursor, RuleValue& out);
    bool call(Cursor& cursor, const Word& function, RuleValue& out);
    bool arguments_of(Cursor& cursor, RuleStep::What what, RuleValue& out);
    bool push(const Cursor& cursor, RuleStep step, RuleValue& out);
    bool push_name(const Word& word, RuleValue& out);
    bool push_number(const Word& word, RuleValue& out);
    std::optional<RuleText::Counted> counted_text(const Word& inside, std::size_t blank);
    std::nullopt_t malformed(const Word& at);
    std::nullopt_t refuse(const Word& at, RuleAdvice advice);
    std::optional<RuleCondition> condition(const std::vector<Word>& words, std::size_t& next);
    std::optional<RuleCondition> comparison(const Word& left, std::string_view sign,
                                            const Word& right);

    const Scope& scope_;
    Context& context_;
    std::vector<RuleNameIr>& names_;
};

/// The quantity of this name; none: there is no such quantity.
std::optional<RuleQuantity> rule_quantity_named(std::string_view name);

}  // namespace carom
