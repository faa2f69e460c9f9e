#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "level/text/diagnostic.h"
#include "level/values/dimension.h"

/// Arithmetic with quantities: what the operators and functions of an expression do.
namespace carom {

/// A value, or why there is none.
struct Outcome {
    Value value;
    FaultCode code;
    std::string fault;  ///< empty: the value holds
    std::string remedy;
};

/// Gives both the same dimension where a bare number stands beside a length (it is one, of the
/// level's unit), an angle (of degrees), or, in natural units, a time; 0 goes with everything.
/// False: they differ.
bool match(Value& a, Value& b, LengthUnit unit);

/// Exponents below 100: beyond, nothing has a use for it, and in the end they would overflow.
bool is_sensible(const Dimension& dimension);

/// Whole, from -1024 to 1024, or 0.5.
bool can_be_exponent(const Value& value);
/// Pre: can_be_exponent(exponent), is_sensible(base.dimension).
Outcome raised(const Value& base, const Value& exponent);

enum class Function { sqrt, sin, cos, tan, abs, min, max, floor, ceil, round };

struct FunctionFacts {
    std::string_view name;
    Function function;
    std::size_t arguments;
};
/// Null when there is none of that name.
const FunctionFacts* function_named(std::string_view name);
std::vector<std::string_view> function_names();

/// `b` counts for min and max alone. Angles are in degrees; floor, ceil and round take bare
/// numbers.
Outcome applied(Function function, Value a, Value b, LengthUnit unit);

}  // namespace carom
