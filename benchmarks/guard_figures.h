#pragma once

#include <string>
#include <vector>

/// Figures of the guard: their file format, and the comparison.
namespace carom::bench {

struct GuardLine {
    std::string scene;
    std::string solver;
    double instructions = 0.0;  ///< a tick
};

/// As text: "SCENE SOLVER INSTRUCTIONS" a line; lines that start with # are comments.
std::string guard_text(const std::vector<GuardLine>& lines);
std::vector<GuardLine> parse_guard(const std::string& text);

/// A sentence for each figure that differs by more than `tolerance` (relative, either way), or that
/// only one of the two has.
std::vector<std::string> guard_differences(const std::vector<GuardLine>& written,
                                           const std::vector<GuardLine>& counted, double tolerance);

}  // namespace carom::bench
