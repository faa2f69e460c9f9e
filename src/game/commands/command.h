#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "game/referees/pool_state.h"
#include "level/scene/pinball_table.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// What a player can do to the world. Lengths, speeds and masses are the world's.
namespace carom {

namespace command {
/// The cue: the ball gets this velocity. Where the tip meets it off its middle it also turns: by
/// `side` to the right and `follow` up, both as shares of the radius. Side needs Model::spin,
/// follow Model::cloth; `follow` = Model::spin makes it roll at once.
struct Strike {
    static constexpr double most_offset = 0.5;  ///< further out, a tip slips off
    BallId ball{};
    Vec2 velocity;
    double side = 0.0;
    double follow = 0.0;
};
/// Takes a ball, or moves the hand that has it.
struct HoldBall {
    BallId ball{};
    Vec2 target;
};
struct DropBall {
    BallId ball{};
};
/// Takes an edge, or moves the hand that has it: where its two ends shall be.
struct HoldCapsule {
    CapsuleId capsule{};
    Vec2 start_target;
    Vec2 end_target;
};
struct DropCapsule {
    CapsuleId capsule{};
};
/// Puts a ball down somewhere else at once; it keeps its velocity. For a world that stands still.
struct PlaceBall {
    BallId ball{};
    Vec2 position;
};
/// Puts an edge down somewhere else at once.
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
/// A button of the game goes down or up (game_state.h).
struct Press {
    Button button = Button::left_flipper;
    bool is_down = false;
};
/// A hand has pulled the plunger so far, 0..1 of its way, and holds it there or lets go of it.
struct Pull {
    double share = 0.0;
    bool lets_go = false;
};
/// Pool: what the next shot shall do; the last call counts.
struct CallShot {
    PoolCall call;
};
/// Pool: what the player whose turn it is decides.
struct Decide {
    PoolChoice choice = PoolChoice::take_table;
};
/// Pool: the next frame.
struct RackAgain {};
}  // namespace command

using Command =
    std::variant<command::Strike, command::HoldBall, command::DropBall, command::HoldCapsule,
                 command::DropCapsule, command::PlaceBall, command::PlaceCapsule, command::AddBall,
                 command::RemoveBall, command::AddCapsule, command::RemoveCapsule,
                 command::SetGravity, command::SetSolver, command::Press, command::CallShot,
                 command::Decide, command::RackAgain, command::Pull>;

/// A command and the tick at which it applies: before tick number `tick` + 1 is computed.
struct TimedCommand {
    std::uint64_t tick = 0;
    Command command;
};

/// Why a command cannot be obeyed, as a sentence for the player; none when it can. A command is
/// refused when it is about what is not there, when a number in it is not finite or out of range,
/// and when it would put a ball or an edge into another body that it meets. A world alone has no
/// buttons and no referee: see game_state.h.
std::optional<std::string> refusal(const World& world, const Command& command);

/// Does to the world what the command says; SetSolver does nothing to it. What is added under
/// Model::filtered, Model::wrap and the rest follows the rules of add_ball and add_capsule.
/// Pre: the command is not refused.
void obey(World& world, const Command& command);

/// Whether `later`, coming right after `earlier`, goes on with its gesture: a drag, from taking to
/// dropping, is one, and so are placings that follow each other, and a call with its shot. A
/// gesture is undone as a whole.
bool continues_gesture(const Command& earlier, const Command& later);

/// Whether it moves an edge by hand. Edges do not hinder each other, so that two such commands of
/// one tick may change places.
bool moves_capsule(const Command& command);

/// Whether both move the same ball or edge by hand: of two such in one gesture and one tick only
/// the later counts.
bool moves_same_hand(const Command& earlier, const Command& later);

}  // namespace carom
