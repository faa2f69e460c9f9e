#pragma once

#include "level/ir/level_ir.h"

namespace carom {

/// Removes mirror duplicates. An item on the line of a mirror, such as a peg or an edge along it,
/// coincides with its own image. Every item that coincides exactly with an earlier item of the same
/// statement, but of another mirror image, is removed. FillIr::balls_before is adjusted.
void remove_mirror_duplicates(LevelIr& ir);

}  // namespace carom
