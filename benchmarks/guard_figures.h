#pragma once

#include <string>
#include <vector>

/// Figures of the guard, as they are written down and compared.
namespace carom::bench {

struct GuardLine {
    std::string scene;
    std::string solver;
    double instructions = 0.0;  ///< a tick
};

/// As text: "SCENE SOLVER INSTRUCTIONS" a line; lines that start with # are for people.
std::string guard_text(const std::vector<GuardLine>& lines);
std::vector<GuardLine> parse_guard(const std::string& text);

/// What has changed by more than `tolerance` (relative), for better or worse, or is not in both; a
/// sentence each.
std::vector<std::string> guard_differences(const std::vector<GuardLine>& written,
                                           const std::vector<GuardLine>& counted, double tolerance);

}  // namespace carom::bench
