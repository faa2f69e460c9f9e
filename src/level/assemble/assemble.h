#pragma once

#include "level/ir/context.h"

/// The last stage of loading: intermediate representation to scene.
namespace carom {

/// A ball at its start. Balls are in the order of the file.
struct StartingBall {
    Vec2 position;
    Vec2 velocity;
    double radius = 1.0;
    double mass = 1.0;
    double restitution = 1.0;
    ClassIndex kind = 0;
    int spec = -1;     ///< index into LevelIr::balls; -1: placed by a fill
    int binding = -1;  ///< index into LevelIr::ball_bindings; -1: placed by a fill
    Origin origin;
};

/// Resolves names, places the balls of fills, checks the physics (checks.h) and, if there is no
/// error, builds the world and the rest of the scene.
void assemble(const LoadOptions& options, Scene& scene, Context& context);

}  // namespace carom
