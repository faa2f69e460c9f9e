#include "level/values/dimension.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "geometry/elementary.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

constexpr std::array units{
    Unit{"um", 1e-6, length_dimension},       Unit{"mm", 1e-3, length_dimension},
    Unit{"cm", 1e-2, length_dimension},       Unit{"m", 1.0, length_dimension},
    Unit{"km", 1e3, length_dimension},        Unit{"in", 0.0254, length_dimension},
    Unit{"mg", 1e-6, mass_dimension},         Unit{"g", 1e-3, mass_dimension},
    Unit{"kg", 1.0, mass_dimension},          Unit{"us", 1e-6, time_dimension},
    Unit{"ms", 1e-3, time_dimension},         Unit{"s", 1.0, time_dimension},
    Unit{"min", 60.0, time_dimension},        Unit{"Hz", 1.0, rate_dimension},
    Unit{"kHz", 1e3, rate_dimension},         Unit{"deg", 1.0, angle_dimension},
    Unit{"rad", 180.0 / pi, angle_dimension}, Unit{"J", 1.0, energy_dimension},
    Unit{"Ns", 1.0, momentum_dimension},      Unit{"Js", 1.0, angular_momentum_dimension},
    Unit{"Pa", 1.0, modulus_dimension},       Unit{"kPa", 1e3, modulus_dimension},
    Unit{"MPa", 1e6, modulus_dimension},      Unit{"GPa", 1e9, modulus_dimension}};

struct NamedDimension {
    Dimension dimension;
    std::string_view name;
};

constexpr std::array named_dimensions{
    NamedDimension{{}, "a number without a unit"},
    NamedDimension{length_dimension, "a length"},
    NamedDimension{mass_dimension, "a mass"},
    NamedDimension{time_dimension, "a time"},
    NamedDimension{angle_dimension, "an angle"},
    NamedDimension{rate_dimension, "a rate"},
    NamedDimension{{2, 0, 0, 0}, "an area"},
    NamedDimension{speed_dimension, "a speed"},
    NamedDimension{{1, 0, -2, 0}, "an acceleration"},
    NamedDimension{{-2, 1, 0, 0}, "a density"},
    NamedDimension{modulus_dimension, "an elastic modulus"},
    NamedDimension{angular_speed_dimension, "an angular speed"},
    NamedDimension{{0, 0, -2, 1}, "an angular acceleration"},
    NamedDimension{energy_dimension, "an energy"},
    NamedDimension{momentum_dimension, "a momentum"},
    NamedDimension{angular_momentum_dimension, "an angular momentum"}};

struct MeasureFacts {
    Measure measure;
    Dimension dimension;
    std::string_view name;
    std::string_view natural_sample;
    std::string_view unit_sample;
};

constexpr std::array measures{
    MeasureFacts{Measure::number, {}, "a number", "0.5", "0.5"},
    MeasureFacts{Measure::whole, {}, "a whole number", "12", "12"},
    MeasureFacts{Measure::length, length_dimension, "a length", "2", "2"},
    MeasureFacts{Measure::angle, angle_dimension, "an angle", "20", "20"},
    MeasureFacts{Measure::time, time_dimension, "a time", "0.5", "50ms"},
    MeasureFacts{Measure::mass, mass_dimension, "a mass", "2", "170g"},
    MeasureFacts{Measure::speed, {1, 0, -1, 0}, "a speed", "3", "0.8m/s"},
    MeasureFacts{Measure::acceleration, {1, 0, -2, 0}, "an acceleration", "9.81", "9.81m/s2"},
    MeasureFacts{Measure::rate, rate_dimension, "a rate", "0.1", "0.1/s"},
    MeasureFacts{Measure::frequency, rate_dimension, "a rate", "120", "120"},
    MeasureFacts{Measure::density, {-2, 1, 0, 0}, "a density", "1", "1kg/m2"},
    MeasureFacts{Measure::modulus, modulus_dimension, "an elastic modulus", "1e6", "5.84GPa"},
    MeasureFacts{Measure::soften, {-1, 0, 1, 0}, "a number", "0.4", "0.4"},
    MeasureFacts{Measure::angular_speed, {0, 0, -1, 1}, "an angular speed", "10", "10rad/s"},
    MeasureFacts{
        Measure::angular_acceleration, {0, 0, -2, 1}, "an angular acceleration", "10", "10rad/s2"}};

const MeasureFacts& facts(Measure measure) {
    return measures[static_cast<std::size_t>(measure)];
}

}  // namespace

double scale(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::millimetre:
            return 1e-3;
        case LengthUnit::centimetre:
            return 1e-2;
        case LengthUnit::inch:
            return 0.0254;
        case LengthUnit::natural:
        case LengthUnit::metre:
            break;
    }
    return 1.0;
}

std::string_view symbol(LengthUnit unit) {
    constexpr std::array<std::string_view, 5> names{"", "mm", "cm", "m", "in"};
    return names[static_cast<std::size_t>(unit)];
}

std::vector<std::string_view> length_unit_names() {
    return {"mm", "cm", "m", "in"};
}

std::optional<LengthUnit> length_unit_named(std::string_view name) {
    using enum LengthUnit;
    for (const LengthUnit unit : {millimetre, centimetre, metre, inch}) {
        if (symbol(unit) == name) return unit;
    }
    return std::nullopt;
}

const Unit* unit_named(std::string_view name) {
    return row_named(units, name);
}

std::vector<std::string_view> unit_names() {
    return names_of(units);
}

std::string si_symbol(const Dimension& dimension) {
    std::string above;
    std::string below;
    const auto add = [&](std::string_view name, int exponent) {
        if (exponent == 0) return;
        std::string& side = exponent > 0 ? above : below;
        if (!side.empty()) side += ' ';
        side += name;
        if (std::abs(exponent) > 1) side += fmt::format("{}", std::abs(exponent));
    };
    add("kg", dimension.mass);
    add("m", dimension.length);
    add("deg", dimension.angle);
    add("s", dimension.time);
    return below.empty() ? above : above + '/' + below;
}

std::string report_unit(const Dimension& dimension) {
    if (dimension.angle != 0) {
        std::string unit = si_symbol(dimension);
        return unit.replace(unit.find("deg"), 3, "rad");
    }
    for (const std::string_view name : {"J", "Ns", "Js"})
        if (unit_named(name)->dimension == dimension) return std::string(name);
    return si_symbol(dimension);
}

std::string described(const Dimension& dimension) {
    for (const NamedDimension& known : named_dimensions) {
        if (known.dimension == dimension) return std::string(known.name);
    }
    return "a quantity in " + si_symbol(dimension);
}

Dimension dimension_of(Measure measure) {
    return facts(measure).dimension;
}

std::string described(Measure measure) {
    return std::string(facts(measure).name);
}

std::string_view sample(Measure measure, LengthUnit unit) {
    return unit == LengthUnit::natural ? facts(measure).natural_sample : facts(measure).unit_sample;
}

std::string written(double number, Measure measure, LengthUnit unit, int digits) {
    const bool is_plain = unit == LengthUnit::natural || measure == Measure::soften ||
                          measure == Measure::frequency || measure == Measure::angle ||
                          number == 0.0;
    if (is_plain) return fmt::format("{:.{}g}", number, digits);
    if (measure == Measure::angular_speed) return fmt::format("{:.{}g}rad/s", number, digits);
    if (measure == Measure::angular_acceleration)
        return fmt::format("{:.{}g}rad/s2", number, digits);
    if (measure == Measure::length) return fmt::format("{:.{}g}", number / scale(unit), digits);
    if (measure == Measure::modulus) return fmt::format("{:.{}g}GPa", number * 1e-9, digits);
    return fmt::format("{:.{}g}{}", number, digits, si_symbol(dimension_of(measure)));
}

}  // namespace carom
