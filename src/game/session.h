#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "level/scene.h"
#include "physics/solver.h"
#include "physics/world.h"

/// A game in progress: a scene, what the player has done to it, and the way back.
namespace carom {

/// What a player can do to the world. Lengths, speeds and masses are the world's.
namespace command {
struct Strike {
    BallId ball{};
    Vec2 velocity;
};  ///< the cue: the ball gets this velocity
struct HoldBall {
    BallId ball{};
    Vec2 target;
};  ///< take it, or move the hand
struct DropBall {
    BallId ball{};
};
struct HoldCapsule {
    CapsuleId capsule{};
    Vec2 start_target;
    Vec2 end_target;
};
struct DropCapsule {
    CapsuleId capsule{};
};
struct AddBall {
    BallSpec spec;
};
struct RemoveBall {
    BallId ball{};
};
struct AddCapsule {
    Capsule shape;
    ClassIndex material = 0;
    Side side = Side::both;
};
struct RemoveCapsule {
    CapsuleId capsule{};
};
struct SetGravity {
    std::optional<Vec2> gravity;
};
struct SetSolver {
    SolverSettings settings;
};
}  // namespace command

using Command =
    std::variant<command::Strike, command::HoldBall, command::DropBall, command::HoldCapsule,
                 command::DropCapsule, command::AddBall, command::RemoveBall, command::AddCapsule,
                 command::RemoveCapsule, command::SetGravity, command::SetSolver>;

/// A command and the tick at which it applies: before tick number `tick` + 1 is computed.
struct TimedCommand {
    std::uint64_t tick = 0;
    Command command;
};

class Session {
  public:
    /// `rewind_bytes`: most memory for the way back (snapshots and commands).
    explicit Session(Scene scene, const SolverSettings& solver,
                     std::size_t rewind_bytes = 64u << 20);

    const Scene& scene() const;
    const World& world() const;
    const SolverSettings& solver() const;
    /// Contacts of the last tick; empty after a restart.
    std::span<const Contact> contacts() const;

    /// Applies at once, before the next tick; logged with the present tick. Commands about what
    /// does not exist, and balls or edges that would overlap others, are refused with a sentence
    /// that says why.
    std::optional<std::string> apply(const Command& command);

    /// One tick forward. Ahead of a rewound session's old future: forgets that future's commands
    /// only when a new command is applied; until then going forward replays them.
    void step_forward();
    /// One tick back, to exactly the state that was. False at the start, or where the memory ends.
    bool step_back();
    /// Goes to a tick in 0..latest by the shortest way.
    bool go_to(std::uint64_t tick);
    /// The earliest tick that can be gone back to, and the latest that has been reached.
    std::uint64_t earliest() const;
    std::uint64_t latest() const;
    /// Back to the start, commands forgotten.
    void restart();

    std::span<const TimedCommand> commands() const;
};

}  // namespace carom
