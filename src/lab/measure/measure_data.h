#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lab/measure/measure.h"

/// What `carom measure` writes for programs; docs/command-line.md lists the keys and the columns.
namespace carom {

/// One JSON object. All of it but what stands under `cost` and `picks` is deterministic. `level` is
/// the level's name as it was asked for; `budget` and `tolerance` as on the command line, none
/// where they were not asked for.
std::string measure_json(std::string_view level, const Measurement& measurement,
                         const std::optional<double>& budget,
                         const std::optional<double>& tolerance);

/// A line of names, and a row for each choice and horizon. Empty cells stand for what there is not.
std::string measure_csv(const Measurement& measurement);

}  // namespace carom
