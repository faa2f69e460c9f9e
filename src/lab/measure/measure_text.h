#pragma once

#include <string>
#include <string_view>

#include "lab/measure/measure.h"

/// What `carom measure` prints for people.
namespace carom {

/// What was measured, against what, and how long that can be believed; the tables of cost, error
/// and faults; the error by horizon; and the plot. At most 80 columns wide, ASCII.
std::string measure_text(std::string_view title, const Measurement& measurement);

/// The answer to --budget, a line: the most accurate choice whose tick of the level costs so many
/// seconds or less; or that there is none, and what the cheapest costs.
std::string budget_answer(const Measurement& measurement, double budget);

/// The answer to --tolerance, a line: the cheapest choice whose error is that or less, in radii.
std::string tolerance_answer(const Measurement& measurement, double tolerance);

}  // namespace carom
