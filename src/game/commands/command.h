#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "game/referees/pool_state.h"
#include "level/scene/pinball_table.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// Commands: a player's changes to a world, as plain data. Lengths, speeds and masses are in the
/// units of the world.
namespace carom {

namespace command {
/// A stroke of the cue, which gives the ball this velocity. A tip that hits the ball off its centre
/// also spins it: `side` to the right and `follow` up, both in radii. `side` needs Model::spin,
/// `follow` needs Model::cloth; `follow` = Model::spin makes the ball roll at once.
struct Strike {
    static constexpr double most_offset = 0.5;  ///< beyond this offset the tip slips off
    BallId ball{};
    Vec2 velocity;
    double side = 0.0;
    double follow = 0.0;
};
/// Grabs a ball, or moves the ball that is held.
struct HoldBall {
    BallId ball{};
    Vec2 target;
};
struct DropBall {
    BallId ball{};
};
/// Grabs an edge, or moves the edge that is held: the targets of its two ends.
struct HoldCapsule {
    CapsuleId capsule{};
    Vec2 start_target;
    Vec2 end_target;
};
struct DropCapsule {
    CapsuleId capsule{};
};
/// Moves a ball at once; it keeps its velocity. For a world that is paused.
struct PlaceBall {
    BallId ball{};
    Vec2 position;
};
/// Moves an edge at once.
struct PlaceCapsule {
    CapsuleId capsule{};
    Vec2 start;
    Vec2 end;
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
/// Presses or releases a button of the game (game_state.h).
struct Press {
    Button button = Button::left_flipper;
    bool is_down = false;
};
/// Pulls the plunger to this share of its travel, 0..1, and holds it there or releases it.
struct Pull {
    double share = 0.0;
    bool lets_go = false;
};
/// Pool: calls the next shot; the last call counts.
struct CallShot {
    PoolCall call;
};
/// Pool: the decision of the player whose turn it is.
struct Decide {
    PoolChoice choice = PoolChoice::take_table;
};
/// Pool: starts the next frame.
struct RackAgain {};
/// Pool: the shot clock has run out. Whoever measures the player's time gives this command.
struct TimeOut {};
/// Pool: the player whose turn it is concedes the frame.
struct Concede {};
}  // namespace command

using Command = std::variant<command::Strike, command::HoldBall, command::DropBall,
                             command::HoldCapsule, command::DropCapsule, command::PlaceBall,
                             command::PlaceCapsule, command::AddBall, command::RemoveBall,
                             command::AddCapsule, command::RemoveCapsule, command::SetGravity,
                             command::SetSolver, command::Press, command::CallShot, command::Decide,
                             command::RackAgain, command::Pull, command::TimeOut, command::Concede>;

/// A command and the tick at which it applies: before tick number `tick` + 1 is computed.
struct TimedCommand {
    std::uint64_t tick = 0;
    Command command;
};

/// Why a command cannot be executed, as a sentence for the player; none if it can. A command is
/// refused if it names a body that does not exist, if a number in it is not finite or out of range,
/// or if it would make a ball or an edge overlap a body that it collides with. A world alone has no
/// buttons and no referee: see game_state.h. Cost: linear in the bodies.
std::optional<std::string> refusal(const World& world, const Command& command);

/// Why a cue that gives at most `most_power`, m/s, cannot strike a ball to this velocity; none if
/// it can.
std::optional<std::string> refusal_of_cue(Vec2 velocity, double most_power);

/// The place of the body that the body of this command would overlap, where that is why the command
/// is refused; none otherwise. Cost: linear in the bodies.
std::optional<Vec2> obstacle_to(const World& world, const Command& command);

/// Executes a command. SetSolver, and commands of games, leave the world unchanged. Bodies are
/// added by the rules of add_ball and add_capsule. Pre: the command is not refused.
void execute(World& world, const Command& command);

/// Whether `later`, right after `earlier`, belongs to the same gesture. A gesture is a drag from
/// grab to release, a run of placements, or a call with its shot. Undo reverts a whole gesture.
bool continues_gesture(const Command& earlier, const Command& later);

/// Whether the command drags an edge. Edges do not obstruct each other, so the order of two such
/// commands in one tick does not matter.
bool moves_capsule(const Command& command);

/// Whether both commands drag the same ball or edge: within one gesture and one tick, only the
/// later one counts.
bool moves_same_hand(const Command& earlier, const Command& later);

}  // namespace carom
