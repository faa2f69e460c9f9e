#pragma once

#include <string>

#include "counted.h"

namespace carom::bench {

/// A line for each term of the model: instructions a ball and tick that it adds under each solver,
/// the bytes a ball that it adds, and by how much the count differs from that of the bare gas when
/// the term is written down but amounts to nothing. `gas`: the text of gas.level.
std::string term_table(InstructionCounter& counter, const std::string& gas);

}  // namespace carom::bench
