#pragma once

#include <vector>

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"
#include "level/assemble/symbol_table.h"

/// Applies the statements `move` and `remove` (LevelIr::amendments), in their order.
namespace carom {

/// Changes `balls` and the edges of the IR. Removed balls stay in their list, so that the
/// numbers of the others do not change: `is_removed` says which. Removed edges are taken out of
/// LevelIr::capsules; their names and numbers in `symbols` stay. Reports bodies that do not
/// exist, and arguments that do not fit. Those of motions are left to
/// MotionAssembly, those of seesaws to SeesawAssembly.
struct Amended {
    std::vector<bool> is_removed;             ///< by ball; empty: none is
    std::vector<std::optional<double>> spin;  ///< by ball; empty: none is changed
    std::vector<std::optional<Vec2>> roll;    ///< by ball; empty: none is changed
    bool removes(std::size_t ball) const { return !is_removed.empty() && is_removed[ball]; }
};
Amended amend(std::vector<StartingBall>& balls, SymbolTable& symbols, Context& context);

}  // namespace carom
