#pragma once

#include <optional>
#include <span>
#include <string>

/// Whether the files that a command writes get in the way of each other, or of what it reads.
namespace carom {

/// Why the outputs cannot be written, as a sentence; none: they can. Two outputs may not be one
/// file, and no output may replace a file that is read. Links to a file and other spellings of its
/// path are that file. "-" is standard output; empty: no file.
std::optional<std::string> clash_of_outputs(std::span<const std::string> outputs,
                                            std::span<const std::string> inputs);

}  // namespace carom
