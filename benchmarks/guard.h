#pragma once

#include <string>
#include <vector>

#include "counted.h"
#include "guard_figures.h"

/// The guard against a loss of speed: instructions a tick of short scenes, under each solver that
/// they are for.
namespace carom::bench {

/// In a fixed order. `scenes`: the folder of the levels.
std::vector<GuardLine> guard_lines(InstructionCounter& counter, const std::string& scenes);

}  // namespace carom::bench
