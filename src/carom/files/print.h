#pragma once

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

/// Prints to standard error, made safe for a terminal line by line (`printable`): names of files
/// may hold anything.
void print_note(std::string_view note);

/// Prints diagnostics to standard error, followed by a count if there are several.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

}  // namespace carom
