#include "level/ir/bounds.h"

#include <algorithm>
#include <cmath>

namespace carom {

bool holds(double number, Bound bound) {
    switch (bound) {
        case Bound::not_negative:
            return number >= 0.0;
        case Bound::positive:
            return number > 0.0;
        case Bound::unit_interval:
            return number >= 0.0 && number <= 1.0;
        case Bound::positive_unit_interval:
            return number > 0.0 && number <= 1.0;
        case Bound::up_to_thousand:
            return number >= 1.0 && number <= 1000.0;
        case Bound::layer:
            return number >= 0.0 && number <= 3.0;
        case Bound::any:
            break;
    }
    return true;
}

std::string_view demand(Bound bound) {
    switch (bound) {
        case Bound::not_negative:
            return "must not be negative";
        case Bound::positive:
            return "must be more than 0";
        case Bound::unit_interval:
            return "must be from 0 to 1";
        case Bound::positive_unit_interval:
            return "must be more than 0, and 1 at most";
        case Bound::up_to_thousand:
            return "must be from 1 to 1000";
        case Bound::layer:
            return "must be from 0 to 3";
        case Bound::any:
            break;
    }
    return "";
}

std::optional<double> nearest_allowed(double number, Bound bound) {
    const double size = std::abs(number);
    switch (bound) {
        case Bound::unit_interval:
        case Bound::positive_unit_interval:
            if (size == 0.0) return std::nullopt;
            return size <= 1.0 ? size : size < 2.0 || size > 100.0 ? 1.0 : size / 100.0;
        case Bound::up_to_thousand:
            return std::clamp(number, 1.0, 1000.0);
        default:
            return number < 0.0 ? std::optional(size) : std::nullopt;
    }
}

}  // namespace carom
