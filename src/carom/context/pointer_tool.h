#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "game/commands/picking.h"
#include "game/session/session.h"
#include "terminal/draw/draw.h"

/// The player's hand on the world, whether a mouse or a cursor moves it: takes balls and edges,
/// pulls the cue, draws edges.
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

    /// Takes what is at most `slack` from the point: a ball, else an end of an edge with all that
    /// is joined to it, else an edge. False when there is nothing.
    bool take(const World& world, Vec2 at, double slack);
    /// A ball that is put where the hand is, at once, whatever else goes on.
    void take_to_place(const World& world, BallId ball, Vec2 at);
    /// The cue on a ball that exists.
    void take_cue(BallId ball, Vec2 at);
    void start_edge(Vec2 at, double radius, ClassIndex material);

    /// The hand is now there. A world that stands still has what is held put there at once, if
    /// there is room.
    Complaint move(Session& session, Vec2 to, bool stands_still);
    /// Opens: drops what it held, shoots with the cue, or makes the edge that was drawn.
    Complaint open(Session& session);
    /// Opens without shooting or drawing.
    void cancel(Session& session);
    /// Opens without a command: the session has gone to another time, and its log says who held
    /// what there.
    void forget() { state_ = Nothing{}; }

    /// Before ticks are computed: tells the session what is held and where, and drops what is held
    /// by nobody (after a rewind, or when a session is taken up again).
    void prepare(Session& session);

    /// What the player should see of it; `unit` is put behind the speed of the cue. With the cue
    /// in the hand also where the ball would go, as far as that is quickly found.
    void mark(const World& world, const SolverSettings& solver, std::string_view unit,
              Marks& marks) const;

  private:
    struct Nothing {};
    struct BallInHand {
        BallId ball{};
        Vec2 grip;  ///< from the hand to the middle of the ball
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

/// The velocity that the cue gives a ball there, pulled to `hand`.
Vec2 cue_velocity(const World& world, Vec2 ball, Vec2 hand);

}  // namespace carom
