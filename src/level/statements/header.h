#pragma once

#include "level/ir/context.h"
#include "physics/version.h"

/// The header of a level: format, title, opening comment, version of the physics, and units. It is
/// read before any statement runs, since all numbers depend on the units.
namespace carom {

inline constexpr int format_version = 1;

/// Reads the header of the level itself. Sets the title, comment and unit of the scene, and the
/// unit and top_level_lets of the context.
void read_header(const std::vector<Node>& nodes, const SourceText& source, Scene& scene,
                 Context& context);

/// Checks the header of an included file: it may have a line `carom`, and if it states units, they
/// must be the level's.
void read_fragment_header(const std::vector<Node>& nodes, Context& context);

}  // namespace carom
