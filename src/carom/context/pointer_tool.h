#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "game/commands/picking.h"
#include "game/session/session.h"
#include "terminal/draw/draw.h"

/// The pointer's tool, moved by the mouse or by the cursor keys: it grabs balls and edges, pulls
/// the cue, or draws an edge.
namespace carom {

/// Why an action failed.
struct Complaint {
    std::string text;           ///< a sentence for the player
    std::optional<Vec2> place;  ///< of the body in the way, if there is one
};

class PointerTool {
  public:
    /// Ball speed per length of pull, 1/s.
    static constexpr double cue_gain = 5.0;

    bool is_empty() const { return std::holds_alternative<Nothing>(state_); }
    bool has_ball() const { return std::holds_alternative<BallInHand>(state_); }
    bool has_edges() const { return std::holds_alternative<EdgesInHand>(state_); }
    bool has_cue() const { return std::holds_alternative<CueInHand>(state_); }
    bool has_new_edge() const { return std::holds_alternative<NewEdge>(state_); }

    /// Grabs an object at the point, else one within `slack` (length) of it: a ball, else an end of
    /// an edge with all ends joined to it, else an edge. False if there is none.
    bool take(const World& world, Vec2 at, double slack);
    /// Grabs a ball to place it: it moves to the pointer at once, even while ticks are computed.
    void grab_to_place(const World& world, BallId ball, Vec2 at);
    /// Puts the cue on a ball. Pre: the ball exists.
    void take_cue(BallId ball, Vec2 at);
    void start_edge(Vec2 at, double radius, ClassIndex material);
    /// Pre: has_new_edge().
    void widen_edge(double factor);
    double edge_width() const;

    /// The pointer has moved. While the game is paused, the held object is placed there at once, if
    /// there is room.
    std::optional<Complaint> move(Session& session, Vec2 to, bool is_paused);
    /// Completes the action: drops the held object, shoots with the cue, or makes the edge.
    std::optional<Complaint> open(Session& session);
    /// Drops the held object, without shooting or making an edge.
    void cancel(Session& session);
    /// Empties the tool without a command. For jumps in time: the session's log knows what was held
    /// then.
    void forget() { state_ = Nothing{}; }

    /// Call this before ticks are computed. It sends the session the position of the held body, and
    /// releases every body that the tool does not hold (after a rewind, or in a resumed session).
    void prepare(Session& session);

    /// Adds the tool to the annotations; `unit` is written after the speed of the cue. While the
    /// cue is pulled, they include the predicted path of the ball, as far as it is quickly found.
    void annotate(const World& world, const SolverSettings& solver, std::string_view unit,
                  Annotations& annotations) const;

  private:
    bool take_within(const World& world, Vec2 at, double slack);

    struct Nothing {};
    struct BallInHand {
        BallId ball{};
        Vec2 grip;  ///< from the pointer to the centre of the ball
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

/// The velocity that the cue gives a ball when pulled back to `hand`; positions in the world.
Vec2 cue_velocity(const World& world, Vec2 ball, Vec2 hand);

}  // namespace carom
