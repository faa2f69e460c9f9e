#pragma once

#include "level/ir/level_ir.h"
#include "physics/world/world.h"

namespace carom {

/// Gives the edges their smooth joints (physics/laws/curve.h). Two edges are joined if they end in
/// the same point, no third one does, their radii are the same, and
///   - both are pieces of the same smooth chain, and turn by 20 degrees at most; or
///   - one of them is the end of a smooth chain, and they turn by no more than that chain does one
///     piece further on. So an arc continues smoothly in an edge that is tangent to it.
/// Edges that a motion moves have no joints.
/// Pre: the edges of the world are those of the level, in their order, and nothing has moved them.
void join_curves(const LevelIr& ir, World& world);

}  // namespace carom
