#include "level/ir/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/elementary.h"
#include "level/ir/bounds.h"
#include "level/text/brackets.h"
#include "physics/world/quantities.h"

namespace carom {
namespace {

// The text of a label before its number: "r=", "rate ", or nothing.
std::string lead_of(const Label& label) {
    return label.name.empty() || label.joint.empty() ? ""
                                                     : fmt::format("{}{}", label.name, label.joint);
}

std::string remedy_for(const Label& label, Measure measure, const Context& context) {
    return fmt::format("write {}, such as {}{}", described(measure), lead_of(label),
                       sample(measure, context.unit));
}

// The number that the author wrote, without its unit; the value of an expression.
std::string own_number(const Word& word, const Value& value) {
    double number = 0.0;
    const char* end = word.text.data() + word.text.size();
    const auto [stop, fault] = std::from_chars(word.text.data(), end, number);
    const bool is_literal = fault == std::errc{} && std::all_of(stop, end, [](char c) {
                                return starts_identifier(c) || c == '/' || c == '2' || c == '3';
                            });
    return is_literal ? std::string(word.text.data(), stop) : fmt::format("{:.6g}", value.number);
}

// "write a time, such as at=20s" for at=20: the author's number with a unit that fits.
std::string remedy_with(const Word& word, const Value& value, const Label& label, Measure measure,
                        const Context& context) {
    const bool is_bare = context.unit == LengthUnit::natural || measure == Measure::length ||
                         measure == Measure::angle || measure == Measure::number ||
                         measure == Measure::whole || measure == Measure::soften ||
                         measure == Measure::frequency;
    const std::string unit = is_bare                    ? ""
                             : measure == Measure::mass ? "g"
                                                        : report_unit(dimension_of(measure));
    return fmt::format("write {}, such as {}{}{}", described(measure), lead_of(label),
                       own_number(word, value), unit);
}

// Converts a value to the units of the world, or reports a wrong dimension.
std::optional<double> converted(const Word& word, const Value& value, const Label& label,
                                Measure measure, Context& context) {
    if (context.is_unit_unknown) return value.number;
    const Dimension wanted = dimension_of(measure);
    const bool is_angular =
        measure == Measure::angular_speed || measure == Measure::angular_acceleration;
    if (is_angular && value.dimension == wanted) return value.number / (180.0 / pi);
    const auto wrong_dimension = [&]() -> std::optional<double> {
        context.reporter.error("wrong-dimension", word.span(),
                               fmt::format("{} is {}, {} is wanted", word.text,
                                           described(value.dimension), described(measure)),
                               remedy_with(word, value, label, measure, context));
        return std::nullopt;
    };
    if (context.unit == LengthUnit::natural) {
        if (value.is_bare()) return value.number;
        const Dimension& d = value.dimension;
        if (d.angle == wanted.angle && d.time == wanted.time) return value.number;
        return wrong_dimension();
    }
    if (value.dimension == wanted || (value.is_bare() && value.number == 0.0)) {
        return value.number;
    }
    if (value.is_bare()) {
        if (measure == Measure::length) return value.number * scale(context.unit);
        if (measure == Measure::angle || measure == Measure::soften ||
            measure == Measure::frequency) {
            return value.number;
        }
        context.reporter.error(
            "unit-missing", word.span(),
            fmt::format("{} has no unit, {} is wanted", word.text, described(measure)),
            remedy_with(word, value, label, measure, context));
        return std::nullopt;
    }
    return wrong_dimension();
}

double rounded_to_six_digits(double number) {
    const std::string text = fmt::format("{:.6g}", number);
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

// Checks the bounds of a number. A remedy shows the number that the author wrote, corrected.
std::optional<double> bounded(const Word& word, double number, const Label& label, Measure measure,
                              Bound bound, Context& context) {
    const std::string subject(label.name.empty() ? described(measure) : std::string(label.name));
    const auto is_out = [&](double value) {
        return (measure == Measure::whole && std::floor(value) != value) || !holds(value, bound);
    };
    // With more digits where six would show a number that is allowed: 1.0000001 is not 1.
    const int digits = is_out(number) && !is_out(rounded_to_six_digits(number)) ? 15 : 6;
    const std::string shown = written(number, measure, context.unit, digits);
    if (measure == Measure::whole && std::floor(number) != number) {
        context.reporter.error("number-not-whole", word.span(),
                               fmt::format("{} must be a whole number, but is {}", subject, shown),
                               fmt::format("write a whole number, such as {}{:.6g}", lead_of(label),
                                           std::ceil(number)));
        return std::nullopt;
    }
    if (!holds(number, bound)) {
        std::string remedy = remedy_for(label, measure, context);
        if (const auto mended = nearest_allowed(number, bound))
            remedy = fmt::format("write {}, such as {}{}", described(measure), lead_of(label),
                                 written(*mended, measure, context.unit));
        if (bound == Bound::layer)
            remedy =
                fmt::format("write {}0 for the table, or 1 for what is above it", lead_of(label));
        context.reporter.error("number-out-of-bounds", word.span(),
                               fmt::format("{} {}, but is {}", subject, demand(bound), shown),
                               remedy);
        return std::nullopt;
    }
    const bool is_positive = bound == Bound::positive || bound == Bound::positive_unit_interval;
    const bool is_too_small = is_positive && number < smallest_positive;
    if (!is_quantity(number) || is_too_small) {
        context.reporter.error("number-out-of-range", word.span(),
                               fmt::format("{} is out of range: {}", subject, shown),
                               "quantities go from 1e-18 to 1e18");
        return std::nullopt;
    }
    return number;
}

std::string numbers_wanted(std::size_t there, int wanted) {
    return fmt::format("{} {} here, {} are wanted", there,
                       there == 1 ? "number stands" : "numbers stand", wanted);
}

}  // namespace

std::optional<double> read_number(const Word& word, const Label& label, Measure measure,
                                  Bound bound, const Scope& scope, Context& context) {
    const std::optional<Value> value = evaluate(word, scope, context.rules(), context.reporter);
    if (!value) return std::nullopt;
    const std::optional<double> number = converted(word, *value, label, measure, context);
    if (!number) return std::nullopt;
    return bounded(word, *number, label, measure, bound, context);
}

std::optional<double> read_quantity(const Word& word, const Dimension& wanted, Bare bare,
                                    Bound bound, const Scope& scope, Context& context) {
    const std::optional<Value> value = evaluate(word, scope, context.rules(), context.reporter);
    if (!value) return std::nullopt;
    double number = value->number;
    const std::string unit = report_unit(wanted);
    const Dimension& is = value->dimension;
    const bool is_natural = context.unit == LengthUnit::natural;
    if (is == wanted) {
        for (int i = 0; i < wanted.angle; ++i)
            number /= 180.0 / pi;
    } else if (context.is_unit_unknown || (value->is_bare() && (is_natural || number == 0.0))) {
        // As it stands.
    } else if (value->is_bare() && wanted == length_dimension &&
               context.unit == LengthUnit::metre) {
        // In metres, whichever rule applies.
    } else if (value->is_bare() && wanted == length_dimension && bare == Bare::like_elsewhere) {
        number *= scale(context.unit);
    } else if (value->is_bare() && bare == Bare::like_elsewhere) {
        context.reporter.error(
            "unit-missing", word.span(),
            fmt::format("{} has no unit, {} is wanted", word.text, described(wanted)),
            fmt::format("write it with its unit, such as {:.6g}{}", number, unit));
        return std::nullopt;
    } else if (value->is_bare()) {
        const std::string own = wanted == length_dimension
                                    ? fmt::format("{:.6g}{} or ", number, symbol(context.unit))
                                    : "";
        context.reporter.warning("result-without-unit", word.span(),
                                 fmt::format("{} has no unit: it is read in {}", word.text, unit),
                                 fmt::format("write {}{:.6g}{}", own, number, unit));
    } else if (!is_natural || is.angle != wanted.angle || is.time != wanted.time) {
        context.reporter.error(
            "wrong-dimension", word.span(),
            fmt::format("{} is {}, {} is wanted", word.text, described(is), described(wanted)),
            is_natural ? fmt::format("write a number without a unit, such as {:.6g}", number)
                       : fmt::format("write a number in {}, such as {:.6g}{}",
                                     unit.empty() ? "no unit" : unit, number, unit));
        return std::nullopt;
    }
    return bounded(word, number, {described(wanted), ""}, Measure::number, bound, context);
}

std::optional<std::pair<double, double>> read_range(const Word& word, const Label& label,
                                                    Measure measure, Bound bound,
                                                    const Scope& scope, Context& context) {
    const std::vector<Word> ends = split_outside_brackets(word, "..");
    if (ends.size() > 2) {
        context.reporter.error("range-of-many", word.span(), "a range has two ends",
                               fmt::format("write {}a..b", lead_of(label)));
        return std::nullopt;
    }
    const auto low = read_number(ends.front(), label, measure, bound, scope, context);
    if (ends.size() == 1 || !low) return low ? std::optional(std::pair{*low, *low}) : std::nullopt;
    const auto high = read_number(ends.back(), label, measure, bound, scope, context);
    if (!high) return std::nullopt;
    if (*low > *high) {
        context.reporter.error("range-backwards", word.span(),
                               fmt::format("the range {} runs backwards", word.text),
                               "write the smaller end first");
        return std::nullopt;
    }
    return std::pair{*low, *high};
}

std::optional<Vec2> read_pair(const Word& word, std::string_view name, Measure measure, Bound bound,
                              const Scope& scope, Context& context) {
    const std::vector<Word> pieces = split_outside_brackets(word, ",");
    if (!are_brackets_closed(word, context.reporter)) return std::nullopt;
    if (pieces.size() != 2) {
        context.reporter.error(
            "pair-of-other-count", word.span(), numbers_wanted(pieces.size(), 2),
            fmt::format("write {}{}x,y without spaces", name, name.empty() ? "" : "="));
        return std::nullopt;
    }
    const Label label{name, ""};
    const auto x = read_number(pieces[0], label, measure, bound, scope, context);
    const auto y = read_number(pieces[1], label, measure, bound, scope, context);
    if (!x || !y) return std::nullopt;
    return Vec2{*x, *y};
}

std::optional<std::array<double, 4>> read_box(const Word& word, std::string_view name,
                                              Measure measure, const Scope& scope,
                                              Context& context) {
    const std::vector<Word> pieces = split_outside_brackets(word, ",");
    if (!are_brackets_closed(word, context.reporter)) return std::nullopt;
    if (pieces.size() != 4) {
        context.reporter.error("box-of-other-count", word.span(), numbers_wanted(pieces.size(), 4),
                               fmt::format("write {}=x0,y0,x1,y1 without spaces", name));
        return std::nullopt;
    }
    std::array<double, 4> box{};
    bool is_complete = true;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto number = read_number(pieces[i], {name, ""}, measure, Bound::any, scope, context);
        box[i] = number.value_or(0.0);
        is_complete = is_complete && number;
    }
    if (!is_complete) return std::nullopt;
    if (box[0] < box[2] && box[1] < box[3]) return box;
    context.reporter.error("box-empty", word.span(), fmt::format("the {} is empty", name),
                           "write the lower left corner first: x0,y0,x1,y1");
    return std::nullopt;
}

}  // namespace carom
