#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "level/ir/context.h"
#include "level/language/statement.h"

/// Words to numbers: evaluated, in the world's units (angles in degrees), within bounds. Where
/// there is no number, the mistake has been reported, or something that the word uses is poisoned.
namespace carom {

/// What a message calls a number, and how its remedy writes it: r=2, rate 120, or just 2.
struct Label {
    std::string_view name;
    std::string_view joint = "=";  ///< empty: the remedy shows the number alone
};

/// One number, in the world's units (angles in degrees), within bounds. None: reported, or poison.
std::optional<double> read_number(const Word& word, const Label& label, Measure measure,
                                  Bound bound, const Scope& scope, Context& context);

/// "x" or "a..b": the two ends, in order.
std::optional<std::pair<double, double>> read_range(const Word& word, const Label& label,
                                                    Measure measure, Bound bound,
                                                    const Scope& scope, Context& context);

/// "x,y".
std::optional<Vec2> read_pair(const Word& word, std::string_view name, Measure measure, Bound bound,
                              const Scope& scope, Context& context);

/// "x0,y0,x1,y1", lower left corner first.
std::optional<std::array<double, 4>> read_box(const Word& word, std::string_view name,
                                              Measure measure, const Scope& scope,
                                              Context& context);

}  // namespace carom
