#pragma once

#include <cstdint>

#include "geometry/vec2.h"

namespace carom {

enum class ContactKind : std::uint8_t { ball_ball, ball_edge };

/// One exchange of momentum. Ball on ball: a < b are the numbers of the balls. Ball on edge: a is
/// the number of the ball, b that of the capsule. Until the solver is done with the tick, a and b
/// are indices in the world instead (solver_table.h).
struct Contact {
    double time = 0.0;  ///< s since the start of the simulation
    ContactKind kind = ContactKind::ball_ball;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Vec2 point;   ///< where they touch; on a torus within it, once the tick is done
    Vec2 normal;  ///< unit, from b to a; what the impulse acted along (turned, under scatter)
    /// Approach speed along the normal before the impact, length/s, > 0. A constraint of `contact`
    /// reports the impulse divided by the effective mass instead, also for a ball at rest.
    double approach = 0.0;
    double impulse = 0.0;  ///< magnitude along the normal, mass * length/s
};

}  // namespace carom
