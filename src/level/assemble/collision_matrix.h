#pragma once

#include <cstdint>
#include <vector>

#include "level/assemble/class_names.h"
#include "level/assemble/resolve_names.h"

namespace carom {

/// The collision matrix of kinds and materials (ResolvedNames::collision_matrix), from the
/// `collide` statements and the layers of a level; empty: all collide. Reports unknown and
/// ambiguous names, and statements that make edges collide with edges. Pre: `names` has its kinds,
/// materials and layers; each layer has `kinds_of_a_layer` kinds.
std::vector<std::uint8_t> make_collision_matrix(const LevelIr& ir, const ResolvedNames& names,
                                                std::size_t kinds_of_a_layer, ClassNames& kinds,
                                                ClassNames& materials, Reporter& reporter);

}  // namespace carom
