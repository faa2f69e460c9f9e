#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vector.h"
#include "physics/contact/contact_memory.h"
#include "physics/memory/large_pages.h"
#include "physics/world/ids.h"
#include "physics/world/model.h"
#include "physics/world/solver_memory.h"
#include "physics/world/world.h"

/// What the solver `event` leaves in the world for its next tick.
namespace carom {

/// How a ball moves.
enum class Motion : std::uint8_t {
    free,      ///< flies
    sliding,   ///< along the side of an edge
    turning,   ///< round an end of an edge, a peg or a ball that rests
    resting,   ///< does not move until it is hit or its support goes
    held,      ///< kinematic: uniform, whatever acts on it; also while time stands still for it
    slipping,  ///< on cloth, over which its lowest point slips
    rolling,   ///< on cloth
    still      ///< on cloth
};

/// Names the edge or ball that supports a ball; on a torus also the periodic image of it.
struct SupportId {
    enum class Kind : std::uint8_t { nothing, edge, ball };
    Kind kind = Kind::nothing;
    std::int8_t across = 0;
    std::int8_t along = 0;
    std::uint32_t number = 0;

    friend bool operator==(const SupportId&, const SupportId&) = default;
};

/// The linear part of a trajectory: at `time`, that of its last event, the ball is at `position`
/// with `velocity`. A trajectory may last for many ticks. It is part of the state, so that a tick
/// continues it instead of starting from the rounded position at the end of the tick before.
struct StoredLinearPart {
    BallId id{};
    std::uint16_t recent_collisions = 0;  ///< see collapse_guard.h; saturates
    Motion motion = Motion::free;
    double time = 0.0;  ///< s since the start
    Vec2 position;
    Vec2 velocity;

    friend bool operator==(const StoredLinearPart&, const StoredLinearPart&) = default;
};

/// The part of a trajectory that curves it, drag apart.
struct StoredCurvedPart {
    Vec2 acceleration;  ///< since the line's `time`, before drag, length/s^2
    Vec2 center;        ///< turning: of the circle; on cloth: the roll (cloth.h) at `time`
    SupportId support;
    SupportId second_support;
    /// Digest of the edges that support the ball, as they were when the trajectory started
    /// (stored_trajectory.h): with another one, the support is gone.
    std::uint32_t support_digest = 0;

    friend bool operator==(const StoredCurvedPart&, const StoredCurvedPart&) = default;
};

/// How a ball on a trajectory turns: with `spin` at `time`, changing at `rate` since.
struct StoredSpin {
    double time = 0.0;   ///< s since the start
    double spin = 0.0;   ///< rad/s, counter-clockwise
    double rate = 0.0;   ///< rad/s^2
    bool rolls = false;  ///< along the side of an edge, without slip

    friend bool operator==(const StoredSpin&, const StoredSpin&) = default;
};

/// Whether anything can curve a trajectory, drag apart: without gravity and cloth nothing
/// accelerates, supports or presses a ball between two events.
inline bool may_curve(const Model& model) {
    return model.gravity || model.cloth;
}

/// The trajectories of all balls, as the last tick left them. One counts only while it leads
/// through the ball's position and velocity, bit by bit, so an outside change voids it.
struct StoredTrajectories {
    LargeVector<StoredLinearPart> lines;   ///< ascending by id
    std::vector<StoredCurvedPart> curves;  ///< beside `lines`; empty unless may_curve
    std::vector<StoredSpin> spins;         ///< beside `lines`; empty unless Model::spin
    Vec2 gravity;                          ///< under which they are valid: any other voids them
    double drag = 0.0;                     ///< 1/s
    /// What the balls could meet when they were stored: digest_of_obstacles (stored_trajectory.h),
    /// or 0 if a kinematic edge moved. With another digest, a trajectory that would have met an
    /// edge before now is void.
    std::uint64_t obstacles = 0;

    friend bool operator==(const StoredTrajectories&, const StoredTrajectories&) = default;
};

/// The base holds the contacts of the balls that `contact` stepped for `event` in a hybrid step.
class EventMemory final : public MemoryOf<EventMemory, ContactMemory> {
  public:
    StoredTrajectories trajectories;
    /// The balls from which the cluster of the next hybrid step grows: `contact` steps them and all
    /// that could meet them (hybrid_cluster.h). Ascending; ids of removed balls are ignored.
    std::vector<BallId> clustered;

    void add_to(Hash& hash, const Model& model, int version) const override;
    std::size_t bytes() const override;
    void forget_trajectories() override;
};

/// What `event` has left in the world; an empty one if it left nothing.
const EventMemory& event_memory(const World& world);
/// To be changed from outside of a tick.
EventMemory& edit_event_memory(World& world);

}  // namespace carom
