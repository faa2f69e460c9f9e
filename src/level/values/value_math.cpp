#include "level/values/value_math.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "geometry/elementary.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

constexpr std::array functions{
    FunctionFacts{"sqrt", Function::sqrt, 1}, FunctionFacts{"sin", Function::sin, 1},
    FunctionFacts{"cos", Function::cos, 1},   FunctionFacts{"tan", Function::tan, 1},
    FunctionFacts{"abs", Function::abs, 1},   FunctionFacts{"min", Function::min, 2},
    FunctionFacts{"max", Function::max, 2},   FunctionFacts{"floor", Function::floor, 1},
    FunctionFacts{"ceil", Function::ceil, 1}, FunctionFacts{"round", Function::round, 1}};

Outcome fault(FaultCode code, std::string what, std::string remedy) {
    return {{}, code, std::move(what), std::move(remedy)};
}

Outcome square_root(const Value& value) {
    const Dimension& d = value.dimension;
    if (value.number < 0.0) {
        return fault("root-of-negative", "the square root of a negative number",
                     "sqrt wants 0 or more");
    }
    if (d.length % 2 != 0 || d.mass % 2 != 0 || d.time % 2 != 0 || d.angle % 2 != 0) {
        return fault("root-of-unit", fmt::format("{} has no square root", described(d)),
                     "take the root of a number, or of a square");
    }
    return {
        .value = {std::sqrt(value.number), {d.length / 2, d.mass / 2, d.time / 2, d.angle / 2}}};
}

Outcome trigonometric(Function function, const Value& a) {
    if (!a.is_bare() && !(a.dimension == angle_dimension)) {
        return fault("wrong-dimension",
                     fmt::format("an angle is wanted, not {}", described(a.dimension)),
                     "angles are in degrees, as in sin(30)");
    }
    const SinCos at = sin_cos_degrees(a.number);
    if (function == Function::sin) return {.value = {at.sin, {}}};
    if (function == Function::cos) return {.value = {at.cos, {}}};
    return {.value = {at.sin / at.cos, {}}};
}

Outcome rounded(Function function, const Value& a) {
    if (!a.is_bare()) {
        return fault("rounded-unit", fmt::format("{} cannot be rounded", described(a.dimension)),
                     "divide it by a unit first, as in floor(W/1mm)");
    }
    if (function == Function::floor) return {.value = {std::floor(a.number), {}}};
    if (function == Function::ceil) return {.value = {std::ceil(a.number), {}}};
    return {.value = {std::floor(a.number + 0.5), {}}};
}

}  // namespace

bool match(Value& a, Value& b, LengthUnit unit) {
    if (a.dimension == b.dimension) return true;
    if (!a.is_bare() && !b.is_bare()) return false;
    Value& bare = a.is_bare() ? a : b;
    const Dimension other = a.is_bare() ? b.dimension : a.dimension;
    const bool is_natural_time = unit == LengthUnit::natural && other == time_dimension;
    if (other == length_dimension) {
        bare.number *= scale(unit);
    } else if (!is_natural_time && !(other == angle_dimension) && bare.number != 0.0) {
        return false;
    }
    bare.dimension = other;
    return true;
}

bool is_sensible(const Dimension& d) {
    constexpr int most = 99;
    return std::abs(d.length) <= most && std::abs(d.mass) <= most && std::abs(d.time) <= most &&
           std::abs(d.angle) <= most;
}

bool can_be_exponent(const Value& value) {
    constexpr double largest_exponent = 1024.0;
    if (!value.is_bare()) return false;
    if (value.number == 0.5) return true;
    return std::floor(value.number) == value.number && std::abs(value.number) <= largest_exponent;
}

Outcome raised(const Value& base, const Value& exponent) {
    if (exponent.number == 0.5) return square_root(base);
    const int count = static_cast<int>(std::abs(exponent.number));
    const Dimension& d = base.dimension;
    Value result{1.0, {d.length * count, d.mass * count, d.time * count, d.angle * count}};
    for (int i = 0; i < count; ++i)
        result.number *= base.number;
    if (exponent.number < 0.0) result = {1.0 / result.number, Dimension{} / result.dimension};
    return {.value = result};
}

const FunctionFacts* function_named(std::string_view name) {
    return row_named(functions, name);
}

std::vector<std::string_view> function_names() {
    return names_of(functions);
}

Outcome applied(Function function, Value a, Value b, LengthUnit unit) {
    switch (function) {
        case Function::sqrt:
            return square_root(a);
        case Function::abs:
            return {.value = {std::abs(a.number), a.dimension}};
        case Function::min:
        case Function::max:
            if (!match(a, b, unit)) {
                return fault("wrong-dimension",
                             fmt::format("{} cannot be compared with {}", described(a.dimension),
                                         described(b.dimension)),
                             "compare like with like");
            }
            return {.value = (function == Function::min) == (b.number < a.number) ? b : a};
        case Function::sin:
        case Function::cos:
        case Function::tan:
            return trigonometric(function, a);
        case Function::floor:
        case Function::ceil:
        case Function::round:
            break;
    }
    return rounded(function, a);
}

}  // namespace carom
