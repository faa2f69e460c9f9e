#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/options/options.h"
#include "carom/options/play_options.h"
#include "physics/solver.h"

namespace carom {

struct NumberRange {
    double least = 0.0;
    double most = 0.0;
};

/// Reads the values of options, and keeps the first mistake, as a sentence for the person who typed
/// it. An empty text is an option that was not given, and gives none.
class OptionReader {
  public:
    /// `option` is its name as typed, such as "--time".
    std::optional<double> number(std::string_view option, const std::string& text,
                                 NumberRange range);
    /// 0 to 2^64 - 1.
    std::optional<std::uint64_t> whole(std::string_view option, const std::string& text);
    /// Ticks a second.
    std::optional<double> rate(const std::string& text);
    /// None for "auto" too: then the level's own solver stands, or else carom picks.
    std::optional<SolverSettings> solver(const std::string& text);
    /// "swept,event@240": solvers, each with a rate of its own if it has one. Exactly `count` of
    /// them, where that is not 0. Empty after a mistake, and for an empty text.
    std::vector<CompareOptions::Side> solvers(const std::string& text, std::size_t count);
    /// "60,120,240": ticks a second.
    std::vector<double> rates(const std::string& text);
    /// Seconds, from a number with its unit: "2ms", "500us", "80ns", "0.1s".
    std::optional<double> duration(std::string_view option, const std::string& text);
    std::optional<RendererChoice> renderer(const std::string& text);
    std::optional<ColorChoice> colors(const std::string& text);

    void refuse(std::string sentence);
    const std::optional<std::string>& mistake() const { return mistake_; }

  private:
    std::optional<SolverKind> available_solver(const std::string& text);

    std::optional<std::string> mistake_;
};

/// Why a solver cannot be used, with those that can; none when it can.
std::optional<std::string> unavailable(SolverKind kind);

}  // namespace carom
