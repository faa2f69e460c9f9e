#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "carom/options/options.h"
#include "physics/solver.h"

/// The values of options: what is typed behind one, turned into what the program works with.
///
/// Every function takes the option's name as typed, such as "--time", and the text behind it. It
/// throws BadValue where the text does not fit.
namespace carom {

/// A sentence for the person who typed it, beginning with the option's name.
struct BadValue : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct NumberRange {
    double least = 0.0;
    double most = 0.0;
};
/// Ticks a second.
inline constexpr NumberRange rate_range{.least = 1e-3, .most = 1e9};

double number_in(NumberRange range, std::string_view option, const std::string& text);
/// 0 to 2^64 - 1.
std::uint64_t whole_number(std::string_view option, const std::string& text);
/// Numbers in `range` with commas between, as in "60,120,240".
std::vector<double> numbers_in(NumberRange range, std::string_view option, const std::string& text);
/// Seconds, from a number with its unit: "2ms", "500us", "80ns", "0.1s".
double duration(std::string_view option, const std::string& text);

/// None for "auto": then the level's own solver stands, or else carom picks.
std::optional<SolverSettings> solver_choice(std::string_view option, const std::string& text);
/// "swept,event@240": solvers, each with a rate of its own if it has one.
std::vector<CompareOptions::Side> solver_list(std::string_view option, const std::string& text);

RendererChoice renderer_option(std::string_view option, const std::string& text);
ColorChoice color_choice(std::string_view option, const std::string& text);

/// Why a solver cannot be used, with those that can; none when it can.
std::optional<std::string> unavailable(SolverKind kind);

}  // namespace carom
