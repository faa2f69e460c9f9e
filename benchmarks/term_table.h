#pragma once

#include <string>

#include "counted.h"

namespace carom::bench {

/// A line for each term of the model: the instructions a ball and tick that it adds under each
/// solver, the bytes a ball that it adds, and by how much the count differs from that of the bare
/// gas when the level states the term with a value that has no effect. `gas`: the text of
/// gas.level.
std::string term_table(InstructionCounter& counter, const std::string& gas);

}  // namespace carom::bench
