#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/text/load_budget.h"
#include "level/text/words.h"
#include "level/values/dimension.h"

/// Expressions: + - * / ^, brackets, names of variables, pi and functions. A variable may be called
/// pi or floor, and then hides the constant or the function.
namespace carom {

/// A name with a value. A variable without a value is an error value: its definition had an error,
/// which has been reported, so uses of it fail without another report.
struct Variable {
    std::optional<Value> value;
    Span defined_at;
    bool* used = nullptr;  ///< set to true when the variable is read; may be null
};

/// The names in scope: those of a block, and through `outer` those of the blocks around it.
struct Scope {
    std::map<std::string, Variable, std::less<>> names;
    Scope* outer = nullptr;

    /// Null: there is none. Adds what the search costs to `cost` (LoadBudget).
    const Variable* find(std::string_view name, std::uint64_t& cost) const;
};

struct ExpressionRules {
    LengthUnit unit = LengthUnit::natural;
    /// Names that the file defines later at top level, with their lines: for the message about a
    /// use before the definition.
    const std::map<std::string, int, std::less<>>* defined_later = nullptr;
    LoadBudget* work = nullptr;  ///< pays for the evaluation; may be null
};

/// The deepest nesting of brackets, signs and powers.
inline constexpr int max_nesting = 32;

/// The value of a whole word. None: the word has an error, which is reported, or uses an error
/// value.
///
/// `sin`, `cos` and `tan` take degrees. `^` takes a whole exponent, or 0.5. A bare number added to
/// a length has the unit of the level, and one added to an angle is in degrees. Numbers beyond
/// 1e300, and results that are not finite, are errors.
std::optional<Value> evaluate(const Word& word, const Scope& scope, const ExpressionRules& rules,
                              Reporter& reporter);

}  // namespace carom
