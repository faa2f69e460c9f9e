#pragma once

#include "level/ir/context.h"

/// The last stage: a draft to a scene.
namespace carom {

/// A ball at its start, in the order of the file.
struct StartingBall {
    Vec2 position;
    Vec2 velocity;
    double radius = 1.0;
    double mass = 1.0;
    double restitution = 1.0;
    double spin = 0.0;  ///< rad/s
    std::optional<Vec2> roll;
    ClassIndex kind = 0;
    int binding = -1;  ///< index into LevelIr::ball_bindings; -1: a fill's
    Origin origin;
};

/// Looks up names, places fills, checks physical sense and, if there is no error, fills in the
/// scene's world and all that refers to it.
void assemble(const LoadOptions& options, Scene& scene, Context& context);

}  // namespace carom
