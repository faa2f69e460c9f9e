#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "level/text/diagnostic.h"
#include "level/values/dimension.h"

/// The operators and functions of expressions, on values with dimensions.
namespace carom {

/// A value, or the fault that prevents one.
struct Outcome {
    Value value;
    FaultCode code;
    std::string fault;  ///< empty: the value is valid
    std::string remedy;
};

/// Makes two values comparable. A bare number takes the dimension of the other value if that is a
/// length (in the unit of the level), an angle (in degrees) or, in natural units, a time; 0 takes
/// any dimension. False: the dimensions differ.
bool match(Value& a, Value& b, LengthUnit unit);

/// Whether all exponents are below 100, which keeps them from overflowing.
bool is_sensible(const Dimension& dimension);

/// Whether the value is a bare whole number from -1024 to 1024, or 0.5.
bool can_be_exponent(const Value& value);
/// `base` to the power `exponent`. Pre: can_be_exponent(exponent), is_sensible(base.dimension).
Outcome raised(const Value& base, const Value& exponent);

enum class Function { sqrt, sin, cos, tan, abs, min, max, floor, ceil, round };

struct FunctionFacts {
    std::string_view name;
    Function function;
    std::size_t arguments;
};
/// Null: there is no function of that name.
const FunctionFacts* function_named(std::string_view name);
std::vector<std::string_view> function_names();

/// Applies the function to `a`, or, for min and max, to `a` and `b`. Angles are in degrees; floor,
/// ceil and round take bare numbers.
Outcome applied(Function function, Value a, Value b, LengthUnit unit);

}  // namespace carom
