#pragma once

#include <cstdint>

#include "geometry/vec2.h"
#include "physics/world/contact.h"
#include "physics/world/terms.h"

/// What the parts of the solvers `discrete` and `substep` share. Plain records.
namespace carom {

/// The constants of a tick, and which step it is.
struct OverlapStep {
    double duration = 0.0;  ///< of an update, s
    int updates = 1;
    Terms terms;
    bool has_several =
        false;              ///< steps in an update, so that balls keep what is left of their time
    bool is_first = false;  ///< of the update: every ball is active
};

/// Two bodies that overlapped in this step and have been separated.
struct OverlapPair {
    std::uint32_t ball = 0;
    std::uint32_t other = 0;  ///< a ball or a capsule
    ContactKind kind = ContactKind::ball_ball;
    Vec2 shift;  ///< of the capsule's image on a torus
};

/// A ball that was pushed in this step.
struct PushedBall {
    std::uint32_t ball = 0;
    double intended = 0.0;  ///< length of the displacement that it would have had
    Vec2 origin;            ///< where the step began for it
};

/// The normal of two bodies with the same centre: any will do, but always the same.
inline constexpr Vec2 normal_when_coincident{1.0, 0.0};

}  // namespace carom
