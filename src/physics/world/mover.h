#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/ids.h"

/// Movers: edges that move by themselves, such as the blades of a windmill, a lift or a door.
namespace carom {

class World;

/// An edge that a mover moves.
struct MovedEdge {
    CapsuleId capsule{};
    Capsule home;  ///< where it is at progress 0

    friend bool operator==(const MovedEdge&, const MovedEdge&) = default;
};

/// Edges that move together as one rigid body. Where they are is a function of the mover's clock
/// alone (`mover_shape`): no force changes it. The clock runs while the mover runs, and waits when
/// the mover cannot move on without crushing a ball (tick/mover_step.h).
///
/// A *round* takes `period` seconds. Its progress goes from 0 to 1, or from 0 to 1 and back to 0 if
/// the mover goes to and fro. The progress turns the edges about `pivot` by up to `angle`, or
/// carries them along `path`.
struct Mover {
    std::vector<MovedEdge> edges;  ///< ascending by capsule; a removed edge is taken out
    double period = 1.0;           ///< s, > 0
    bool is_round = true;          ///< it never turns back: progress is clock / period
    /// To and fro at constant speed, which jumps where it turns back. Otherwise the progress is
    /// (1 - cos(2 pi clock / period)) / 2, which starts and stops gently.
    bool is_steady = false;
    Vec2 pivot;
    double angle = 0.0;  ///< rad at progress 1, counter-clockwise; 0: it does not turn
    /// Displacements from home, from corner to corner, the first 0; empty: it only turns. Progress
    /// is the share of its length.
    std::vector<Vec2> path;
    /// It stops so many times in a round, evenly in time, and waits to be started again; 0: never.
    std::uint32_t stops = 0;

    bool runs = true;
    double clock = 0.0;  ///< s, in 0..period
    /// How much of its step the last tick allowed it, 0..1.
    double share = 1.0;

    friend bool operator==(const Mover&, const Mover&) = default;
};

/// The state of a mover's clock.
struct MoverClock {
    double clock = 0.0;
    bool runs = true;
};

/// The clock `duration` seconds later. Pre: the mover runs; 0 <= duration < period.
MoverClock clock_after(const Mover& mover, double duration);

/// Where an edge of the mover is when its clock shows `clock`.
Capsule mover_shape(const Mover& mover, const MovedEdge& edge, double clock);

/// Whether a mover moves this edge, now or when it is started.
bool is_moved_by_mover(const World& world, CapsuleId id);

/// Whether that, or it is the edge of a seesaw.
bool moves_by_itself(const World& world, CapsuleId id);

}  // namespace carom
