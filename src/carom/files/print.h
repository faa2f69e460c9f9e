#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "level/text/diagnostic.h"

/// Output for people on the two standard streams.
namespace carom {

/// Prints to standard output. False if it could not be written (standard error then says why); a
/// closed pipe is no error.
bool print_out(std::string_view text);

/// Prints "carom: error: SENTENCE" to standard error.
void print_error(std::string_view sentence);

/// Prints the lines of a problem. A message that does not name its place, as those of levels do, is
/// printed as by `print_error`.
void print_problems(std::span<const std::string> lines);

/// Prints to standard error, made safe for a terminal line by line (`printable`): names of files
/// may hold anything.
void print_note(std::string_view note);

/// Prints diagnostics to standard error, followed by a count if there are several.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

}  // namespace carom
