#pragma once

#include "level/ir/context.h"

/// What a level says of itself before anything else is understood: format, title, opening comment,
/// version of the physics, units.
namespace carom {

inline constexpr int format_version = 1;
inline constexpr int physics_version = 1;

/// Of the level itself. Fills the scene's title, comment and unit, and the context's unit and
/// top_level_lets.
void read_header(const std::vector<Node>& nodes, const SourceText& source, Scene& scene,
                 Context& context);

/// Of an included file: it may have a line `carom` and must not have other units.
void read_fragment_header(const std::vector<Node>& nodes, Context& context);

}  // namespace carom
