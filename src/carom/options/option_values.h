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

/// Parses the values of options.
///
/// Every function takes the option's name as typed, such as "--time", and its argument. It throws
/// BadValue if the argument is invalid.
namespace carom {

/// A sentence for the user, beginning with the option's name.
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
std::uint64_t whole_number_in(std::uint64_t least, std::uint64_t most, std::string_view option,
                              const std::string& text);
std::uint64_t whole_number(std::string_view option, const std::string& text);
/// Numbers in `range`, separated by commas: "60,120,240".
std::vector<double> numbers_in(NumberRange range, std::string_view option, const std::string& text);
/// Parses a number with its unit into seconds: "2ms", "500us", "80ns", "0.1s".
double duration(std::string_view option, const std::string& text);

/// None for "auto": the level's own solver is used, or else carom picks one.
std::optional<SolverSettings> solver_choice(std::string_view option, const std::string& text);
/// "swept,event@240": solvers, each optionally with its own rate.
std::vector<CompareOptions::Side> solver_list(std::string_view option, const std::string& text);

RendererChoice renderer_option(std::string_view option, const std::string& text);
ColorChoice color_choice(std::string_view option, const std::string& text);
PictureFormat picture_format(std::string_view option, const std::string& text);
CheckFormat check_format(std::string_view option, const std::string& text);
/// "120x40": columns and rows, 1 to 1000 each.
struct WindowSize {
    int columns = 0;
    int rows = 0;
};
WindowSize window_size(std::string_view option, const std::string& text);
ThemeChoice theme_option(std::string_view option, const std::string& text);

/// Solvers of `carom measure`, which takes no rates with them.
std::vector<SolverKind> solvers_of_measure(std::string_view option, const std::string& text);
/// "swept,discrete@480".
std::vector<CompareOptions::Side> two_solvers(std::string_view option, const std::string& text);
std::string guest_name(std::string_view option, const std::string& text);
/// Seconds, from 0.1 to 1e6.
double idle_time(std::string_view option, const std::string& text);
std::size_t bytes_of_mebibytes(std::string_view option, const std::string& text);

/// "discrete, substep, swept": all that are available, for help.
std::string solver_names();
std::string renderer_names();

/// The reason why a solver cannot be used, with those that can; none if it can.
std::optional<std::string> unavailable(SolverKind kind);

}  // namespace carom
