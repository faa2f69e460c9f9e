#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/scene/scene.h"

/// What a number measures, and the units that it may be written in.
namespace carom {

/// Exponents. All zero: a bare number, which is whatever it is used for.
struct Dimension {
    int length = 0;
    int mass = 0;
    int time = 0;
    int angle = 0;

    friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
    return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
}
constexpr Dimension operator/(const Dimension& a, const Dimension& b) {
    return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle};
}

/// SI, but for angles, which are in degrees until they are used: so right angles stay exact.
struct Value {
    double number = 0.0;
    Dimension dimension;

    bool is_bare() const { return dimension == Dimension{}; }
};

/// Bare lengths times this are metres; 1 for natural units.
double scale(LengthUnit unit);
/// "mm", "cm", "m", "in"; empty for natural units.
std::string_view symbol(LengthUnit unit);
/// None when a level may not be written in it.
std::optional<LengthUnit> length_unit_named(std::string_view name);
/// What `units` may say.
std::vector<std::string_view> length_unit_names();

/// A unit without fractions, such as mm, kg, ms or deg: its size (SI, degrees) and its dimension.
struct Unit {
    std::string_view name;
    double size = 1.0;
    Dimension dimension;
};
const Unit* unit_named(std::string_view name);
std::vector<std::string_view> unit_names();

/// "a length", "a speed", ...; "a quantity in m2/s" where there is no word for it.
std::string described(const Dimension& dimension);
/// "m/s2", "kg"; empty for a bare number; degrees for angles.
std::string si_symbol(const Dimension& dimension);

/// What a statement wants in a place.
enum class Measure {
    number,
    whole,  ///< a number without a fraction
    length,
    angle,
    time,
    mass,
    speed,
    acceleration,
    rate,                  ///< 1/s, carries its unit
    frequency,             ///< 1/s, bare also where the level has units
    density,               ///< mass/length^2
    soften,                ///< s/length, bare: s/m
    angular_speed,         ///< rad/s; bare, where the level has no units, rad/s too
    angular_acceleration,  ///< rad/s2, as angular_speed
    result                 ///< whatever an experiment yields: bare, or SI
};

Dimension dimension_of(Measure measure);
/// "a length", "a whole number", ...
std::string described(Measure measure);
/// A fit value as it may be written in a level of these units: "2", "0.8m/s".
std::string_view sample(Measure measure, LengthUnit unit);
/// A value as the author would write it, to 6 digits: -0.2, 0.003kg.
std::string written(double number, Measure measure, LengthUnit unit);

}  // namespace carom
