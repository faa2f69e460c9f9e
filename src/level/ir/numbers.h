#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "level/ir/context.h"
#include "level/language/statement.h"

/// Evaluates words to numbers in the units of the world (angles in degrees), and checks dimensions
/// and bounds. No result: an error, which is reported, or the use of an error value.
namespace carom {

/// The name of a number in messages, and how a remedy writes it: r=2, rate 120, or 2 alone.
struct Label {
    std::string_view name;
    std::string_view joint = "=";  ///< empty: the remedy shows the number alone
};

/// A number.
std::optional<double> read_number(const Word& word, const Label& label, Measure measure,
                                  Bound bound, const Scope& scope, Context& context);

/// How a bare number is read in a level with units.
enum class Bare {
    like_elsewhere,  ///< a length is in the unit of the level; other quantities need their unit
    si               ///< in SI units, with a warning unless the wanted quantity is a pure number
};

/// A number of any dimension. Angles are converted to radians.
std::optional<double> read_quantity(const Word& word, const Dimension& wanted, Bare bare,
                                    Bound bound, const Scope& scope, Context& context);

/// A range "a..b", or "a", which stands for "a..a": its ends, the smaller first.
std::optional<std::pair<double, double>> read_range(const Word& word, const Label& label,
                                                    Measure measure, Bound bound,
                                                    const Scope& scope, Context& context);

/// A pair "x,y".
std::optional<Vec2> read_pair(const Word& word, std::string_view name, Measure measure, Bound bound,
                              const Scope& scope, Context& context);

/// A box "x0,y0,x1,y1", lower left corner first.
std::optional<std::array<double, 4>> read_box(const Word& word, std::string_view name,
                                              Measure measure, const Scope& scope,
                                              Context& context);

}  // namespace carom
