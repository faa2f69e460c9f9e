#pragma once

#include <string>
#include <vector>

#include "counted.h"

/// The guard against a loss of speed: instructions a tick of short scenes, under each solver that
/// they are for, against figures that were written down.
namespace carom::bench {

struct GuardLine {
    std::string scene;
    std::string solver;
    double instructions = 0.0;  ///< a tick
};

/// In a fixed order. `scenes`: the folder of the levels.
std::vector<GuardLine> guard_lines(InstructionCounter& counter, const std::string& scenes);

/// As text: "SCENE SOLVER INSTRUCTIONS" a line; lines that start with # are for people.
std::string guard_text(const std::vector<GuardLine>& lines);
std::vector<GuardLine> parse_guard(const std::string& text);

/// What has changed by more than `tolerance` (relative), for better or worse, or is not in both; a
/// sentence each.
std::vector<std::string> guard_differences(const std::vector<GuardLine>& written,
                                           const std::vector<GuardLine>& counted, double tolerance);

}  // namespace carom::bench
