#pragma once

#include "level/ir/level_ir.h"

namespace carom {

/// What lies on a mirror's line is its own image: a peg on it, a ball, an edge that runs along it.
/// Such an image is not made a second time. Removes every item that coincides exactly with an
/// earlier one from the same statement, but from another image of it. Counts what fills precede
/// anew.
void remove_mirror_duplicates(LevelIr& ir);

}  // namespace carom
