#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "level/text/diagnostic.h"
#include "level/values/dimension.h"

/// Literal numbers, with or without a unit: 12, .5, 1e-3, 0.8m/s2.
namespace carom {

/// The largest number that a level may write or compute.
inline constexpr double largest_number = 1e300;

/// A number with its unit, or a fault.
struct Literal {
    Value value;
    std::size_t length = 0;  ///< bytes that it occupies
    FaultCode code;
    std::string fault;  ///< empty: the value is valid
    std::string remedy;
    std::size_t fault_at = 0;  ///< the byte at which the faulty part begins
    std::size_t fault_length = 0;
};

/// Whether a literal begins here: a digit, or a point and a digit.
bool begins_literal(std::string_view text);

/// Reads the longest literal at the start of `text`: all of 0.8m/s2, but only the 0 of "0..10".
/// After a bare number, /s is a unit unless `is_let` knows a variable of that name. A level in
/// natural units has units of time and angle only. Pre: begins_literal(text).
Literal read_literal(std::string_view text, LengthUnit unit,
                     const std::function<bool(std::string_view)>& is_let);

}  // namespace carom
