#pragma once

#include <optional>
#include <string_view>

#include "level/language/statement.h"

/// What each Bound of a number demands.
namespace carom {

bool holds(double number, Bound bound);

/// The demand as the end of a sentence: "must be more than 0"; empty for Bound::any.
std::string_view demand(Bound bound);

/// A number like the one out of bounds that is allowed: without its sign, or a share in place of
/// percent. None: there is no such number.
std::optional<double> nearest_allowed(double number, Bound bound);

}  // namespace carom
