#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/text/words.h"
#include "level/values/dimension.h"

/// Arithmetic wherever a number may stand: + - * / ^, brackets, let names, pi and functions. A let
/// may be called pi or floor too, and then comes first.
namespace carom {

/// A name that has a value. Without one it is poisoned: its own mistake has been told already, and
/// whatever uses it fails in silence.
struct Variable {
    std::optional<Value> value;
    Span defined_at;
    bool* used = nullptr;  ///< set when the variable is read; may be null
};

/// Names that hold here, and through `outer` those that hold around.
struct Scope {
    std::map<std::string, Variable, std::less<>> names;
    Scope* outer = nullptr;

    const Variable* find(std::string_view name) const;
};

struct ExpressionRules {
    LengthUnit unit = LengthUnit::natural;
    /// Names that get a value later in the file, for the remedy.
    const std::map<std::string, int, std::less<>>* defined_later = nullptr;
};

/// Deepest brackets.
inline constexpr int max_nesting = 32;

/// The value of a whole word. None: a mistake, reported here or (poison) where it was made.
///
/// `sin`, `cos` and `tan` take degrees. `^` wants a whole exponent, or 0.5. A bare number added to
/// a length or an angle is one (of the level's unit, of degrees). Numbers beyond 1e300, and results
/// that are not finite, are mistakes.
std::optional<Value> evaluate(const Word& word, const Scope& scope, const ExpressionRules& rules,
                              Reporter& reporter);

/// Where `text` splits at `separator` outside of brackets: the pieces' offsets and lengths.
std::vector<Word> split_outside_brackets(const Word& word, std::string_view separator);

}  // namespace carom
