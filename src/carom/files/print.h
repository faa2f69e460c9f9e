#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "level/text/diagnostic.h"

/// What carom writes for people to the two standard streams.
namespace carom {

/// To standard output. False when it could not be written (standard error then says why); a
/// closed pipe is no fault.
bool print_out(std::string_view text);

/// "carom: error: SENTENCE" to standard error.
void print_error(std::string_view sentence);

/// To standard error, as it is.
void print_note(std::string_view text);

/// To standard error, one after another, with a line that counts them when they are several.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

}  // namespace carom
