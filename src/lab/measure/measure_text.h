#pragma once

#include <string>
#include <string_view>

#include "lab/measure/measure.h"

/// The output of `carom measure` for people.
namespace carom {

/// The subject, the reference, and how long it can be trusted; the tables of cost, error and
/// faults; the error by horizon; and the plot. At most 80 columns wide, ASCII.
std::string measure_text(std::string_view title, const Measurement& measurement);

/// One line: what the level itself runs under, and its cost and faults. Empty if it was not
/// measured.
std::string own_answer(const Measurement& measurement);

/// The answer to --budget, one line: the choice with the lowest worst fault whose tick of the level
/// takes at most so many seconds; or that there is none, and the cost of the cheapest.
std::string budget_answer(const Measurement& measurement, double budget);

/// The answer to --tolerance, one line: the cheapest choice with at most that error, in radii, that
/// keeps the other promises (faults.h).
std::string tolerance_answer(const Measurement& measurement, double tolerance);

}  // namespace carom
