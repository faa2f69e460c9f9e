#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lab/measure/measure.h"

/// The output of `carom measure` for programs; docs/command-line.md lists the keys and columns.
namespace carom {

/// One JSON object. Everything except the objects `cost` and `picks` is deterministic. `level`: the
/// level's name as the user gave it; `budget` and `tolerance`: as on the command line, none if
/// absent.
std::string measure_json(std::string_view level, const Measurement& measurement,
                         const std::optional<double>& budget,
                         const std::optional<double>& tolerance);

/// CSV: a line of names, and a row for each choice and horizon. Missing values are empty cells.
std::string measure_csv(const Measurement& measurement);

}  // namespace carom
