#include "guard_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace carom::bench {
namespace {

const GuardLine* find(const std::vector<GuardLine>& lines, const GuardLine& like) {
    const auto found = std::ranges::find_if(lines, [&like](const GuardLine& line) {
        return line.scene == like.scene && line.solver == like.solver;
    });
    return found == lines.end() ? nullptr : &*found;
}

}  // namespace

std::string guard_text(const std::vector<GuardLine>& lines) {
    std::string text =
        "# Instructions a tick, counted by callgrind: g++ 12, -O3, x86-64. scripts/instructions\n"
        "# compares; scripts/instructions --update writes this file anew.\n";
    for (const GuardLine& line : lines)
        text += fmt::format("{} {} {:.0f}\n", line.scene, line.solver, line.instructions);
    return text;
}

std::vector<GuardLine> parse_guard(const std::string& text) {
    std::vector<GuardLine> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        GuardLine parsed;
        if (!line.starts_with('#') && words >> parsed.scene >> parsed.solver >> parsed.instructions)
            lines.push_back(parsed);
    }
    return lines;
}

std::vector<std::string> guard_differences(const std::vector<GuardLine>& written,
                                           const std::vector<GuardLine>& counted,
                                           double tolerance) {
    std::vector<std::string> differences;
    for (const GuardLine& line : counted) {
        const GuardLine* before = find(written, line);
        if (!before) {
            differences.push_back(
                fmt::format("{} under {}: not written down", line.scene, line.solver));
            continue;
        }
        const double change = line.instructions / before->instructions - 1.0;
        if (std::abs(change) > tolerance) {
            differences.push_back(fmt::format("{} under {}: {:.0f} instructions a tick, {:+.1f} %",
                                              line.scene, line.solver, line.instructions,
                                              100.0 * change));
        }
    }
    for (const GuardLine& line : written) {
        if (!find(counted, line))
            differences.push_back(fmt::format("{} under {}: not there", line.scene, line.solver));
    }
    return differences;
}

}  // namespace carom::bench
