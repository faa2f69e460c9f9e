#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "game/commands/picking.h"
#include "game/session/session.h"
#include "terminal/draw/draw.h"

/// What the pointer does to the world, whether the mouse or the cursor keys move it: it grabs balls
/// and edges, pulls the cue, or draws an edge.
namespace carom {

/// Why something did not work, as a sentence for the player.
using Complaint = std::optional<std::string>;

class PointerTool {
  public:
    /// Ball speed for each length that the cue is pulled, 1/s.
    static constexpr double cue_gain = 5.0;

    bool is_empty() const { return std::holds_alternative<Nothing>(state_); }
    bool has_ball() const { return std::holds_alternative<BallInHand>(state_); }
    bool has_edges() const { return std::holds_alternative<EdgesInHand>(state_); }
    bool has_cue() const { return std::holds_alternative<CueInHand>(state_); }
    bool has_new_edge() const { return std::holds_alternative<NewEdge>(state_); }

    /// Grabs what is at most `slack` (length) from the point: a ball, else an end of an edge with
    /// all ends joined to it, else an edge. False when there is nothing.
    bool take(const World& world, Vec2 at, double slack);
    /// Grabs a ball to place it: it goes where the pointer is at once, even while ticks are run.
    void take_to_place(const World& world, BallId ball, Vec2 at);
    /// Puts the cue on a ball. Pre: there is such a ball.
    void take_cue(BallId ball, Vec2 at);
    void start_edge(Vec2 at, double radius, ClassIndex material);

    /// The pointer has moved. While the game stands still, what is held is placed there at once, if
    /// there is room.
    Complaint move(Session& session, Vec2 to, bool stands_still);
    /// Completes the action: drops what is held, shoots with the cue, or makes the edge.
    Complaint open(Session& session);
    /// Drops what is held, without shooting or making an edge.
    void cancel(Session& session);
    /// Empties the tool without a command: the session has gone to another time, and its log says
    /// what was held there.
    void forget() { state_ = Nothing{}; }

    /// Before ticks are computed: tells the session what is held and where, and drops what the tool
    /// does not hold (after a rewind, or when a session is resumed).
    void prepare(Session& session);

    /// What the player should see of it; `unit` is put behind the speed of the cue. While the cue
    /// is pulled, also the predicted path of the ball, as far as it is quickly found.
    void mark(const World& world, const SolverSettings& solver, std::string_view unit,
              Marks& marks) const;

  private:
    struct Nothing {};
    struct BallInHand {
        BallId ball{};
        Vec2 grip;  ///< from the pointer to the middle of the ball
        Vec2 at;
        bool is_placed = false;
    };
    struct EdgesInHand {
        EdgeGrip grip;
        Vec2 at;
        CapsuleId edge{};
    };
    struct CueInHand {
        BallId ball{};
        Vec2 at;
    };
    struct NewEdge {
        Capsule shape;
        ClassIndex material = 0;
    };

    std::vector<Command> holds(const World& world) const;
    bool holds_ball(BallId ball) const;
    bool holds_edge(CapsuleId edge) const;

    std::variant<Nothing, BallInHand, EdgesInHand, CueInHand, NewEdge> state_;
};

/// The velocity that the cue gives a ball there, pulled to the place `hand`; both in the world.
Vec2 cue_velocity(const World& world, Vec2 ball, Vec2 hand);

}  // namespace carom
