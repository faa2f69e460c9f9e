#pragma once

#include <vector>

#include "level/language/statement.h"

/// Statements with which the interpreter (build/interpreter.h) runs other statements, or gives
/// names a value. They need Frame::interpreter.
namespace carom {

std::vector<Statement> variable_statements();  ///< let
std::vector<Statement> block_statements();     ///< mirror, repeat, part, place, include

}  // namespace carom
