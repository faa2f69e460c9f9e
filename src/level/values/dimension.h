#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/scene/physical_dimension.h"
#include "level/scene/scene.h"

/// Physical dimensions, and the units of the level language.
namespace carom {

/// A number with a dimension, in SI units. Angles are in degrees until they are used, so that right
/// angles stay exact.
struct Value {
    double number = 0.0;
    Dimension dimension;

    bool is_bare() const { return dimension == Dimension{}; }
};

/// Metres in the unit; 1 for natural units.
double scale(LengthUnit unit);
/// "mm", "cm", "m", "in"; empty for natural units.
std::string_view symbol(LengthUnit unit);
/// None: a level cannot use this unit.
std::optional<LengthUnit> length_unit_named(std::string_view name);
/// The units that the statement `units` takes.
std::vector<std::string_view> length_unit_names();

/// A unit that is not a quotient, such as mm, kg, ms or deg, with its size (in SI units or
/// degrees).
struct Unit {
    std::string_view name;
    double size = 1.0;
    Dimension dimension;
};
const Unit* unit_named(std::string_view name);
std::vector<std::string_view> unit_names();

/// "a length", "a speed", ...; "a quantity in m2/s" for a dimension without a name.
std::string described(const Dimension& dimension);
/// "m/s2", "kg"; empty for a bare number; degrees for angles.
std::string si_symbol(const Dimension& dimension);
/// The unit of a quantity in reports, as a level can write it: "m", "J", "rad/s".
std::string report_unit(const Dimension& dimension);

/// The kind of number that a statement expects.
enum class Measure {
    number,
    whole,  ///< a number without a fraction
    length,
    angle,
    time,
    mass,
    speed,
    acceleration,
    rate,                 ///< 1/s; needs its unit in a level with units
    frequency,            ///< 1/s; may be bare in a level with units
    density,              ///< mass/length^2
    modulus,              ///< of elasticity, mass/(length s^2)
    soften,               ///< s/length; a bare number is in s/m
    angular_speed,        ///< rad/s; a bare number in a level without units is in rad/s
    angular_acceleration  ///< rad/s2; bare numbers like angular_speed
};

Dimension dimension_of(Measure measure);
/// "a length", "a whole number", ...
std::string described(Measure measure);
/// An example value in a level with these units: "2", "0.8m/s".
std::string_view sample(Measure measure, LengthUnit unit);
/// `number`, in the units of the world, as written in a level, to 6 digits: -0.2, 0.003kg.
std::string written(double number, Measure measure, LengthUnit unit, int digits = 6);

}  // namespace carom
