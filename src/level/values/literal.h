#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "level/text/diagnostic.h"
#include "level/values/dimension.h"

/// Numbers as people write them: 12, .5, 1e-3, 0.8m/s2.
namespace carom {

/// No number of a level is larger, nor any result of its arithmetic.
inline constexpr double largest_number = 1e300;

/// A number with its unit, or what is wrong with it.
struct Literal {
    Value value;
    std::size_t length = 0;  ///< bytes of it
    FaultCode code;
    std::string fault;  ///< empty: the value holds
    std::string remedy;
    std::size_t fault_at = 0;  ///< the part of the text that it is about
    std::size_t fault_length = 0;
};

/// Whether the text begins with a digit, or with a point and a digit.
bool begins_literal(std::string_view text);

/// The number that the text begins with, as long as it can be made: 0.8m/s2 is one, "0..10" begins
/// with 0. After a bare number, /s is a unit unless a `let` has that name. In natural units there
/// are times and angles, and no other units. Pre: begins_literal(text).
Literal read_literal(std::string_view text, LengthUnit unit,
                     const std::function<bool(std::string_view)>& is_let);

}  // namespace carom
