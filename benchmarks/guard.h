#pragma once

#include <string>
#include <vector>

#include "counted.h"
#include "guard_figures.h"

/// The guard against slower solvers: instructions a tick of short scenes, under each solver that
/// suits the scene.
namespace carom::bench {

/// In a fixed order. `scenes`: the folder of the levels.
std::vector<GuardLine> guard_lines(InstructionCounter& counter, const std::string& scenes);

}  // namespace carom::bench
