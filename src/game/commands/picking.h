#pragma once

#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "geometry/shapes.h"
#include "physics/world/world.h"

/// What is under a hand. Lengths are the world's. On a torus (Model::wrap) distances go over the
/// nearest images. Ties go to the lower id.
namespace carom {

/// From `a` to `b`, the shortest way on a torus.
Vec2 offset(const World& world, Vec2 a, Vec2 b);

/// The ball whose rim or inside is nearest `point`, at most `slack` away from it. Of several discs
/// that hold the point, the one whose centre is nearest.
std::optional<BallId> ball_at(const World& world, Vec2 point, double slack);

/// One end of an edge.
struct EdgeEnd {
    CapsuleId capsule{};
    bool is_end = false;  ///< Capsule::end; else Capsule::start

    friend bool operator==(const EdgeEnd&, const EdgeEnd&) = default;
};

Vec2 position(const World& world, const EdgeEnd& end);

/// The end whose rounded rim or inside is nearest `point`, at most `slack` away.
std::optional<EdgeEnd> edge_end_at(const World& world, Vec2 point, double slack);

/// The edge nearest `point`, at most `slack` away from its rim; inside counts as 0.
std::optional<CapsuleId> edge_at(const World& world, Vec2 point, double slack);

/// All ends that lie exactly where this one does, itself included: the joint of a polyline, which
/// moves as one. In ascending order of id, start before end.
std::vector<EdgeEnd> joint(const World& world, const EdgeEnd& end);

/// The ball after (or before) `from` in the order of ids, round and round; the first (or last) when
/// `from` is not there. None when there are no balls.
std::optional<BallId> next_ball(const World& world, std::optional<BallId> from,
                                bool backwards = false);

/// A hand on edges, and what it moves: the ends that it carries keep their places relative to it.
struct EdgeGrip {
    struct Part {
        CapsuleId capsule{};
        Vec2 start;  ///< where the ends were when they were taken
        Vec2 end;
        bool moves_start = false;
        bool moves_end = false;
    };
    std::vector<Part> parts;  ///< ascending by capsule
    Vec2 taken_at;
};

/// A hand on the joint that `end` belongs to. A peg, both of whose ends are there, moves as a
/// whole. Pre: the edge exists.
EdgeGrip grip_joint(const World& world, const EdgeEnd& end, Vec2 hand);

/// A hand on all of an edge, and on the edges that are joined to it. Pre: the edge exists.
EdgeGrip grip_edge(const World& world, CapsuleId capsule, Vec2 hand);

/// The commands that move the hand, or open it: one for each edge that is still there. `place` is
/// for a world that stands still.
std::vector<Command> carry(const World& world, const EdgeGrip& grip, Vec2 hand);
std::vector<Command> place(const World& world, const EdgeGrip& grip, Vec2 hand);
std::vector<Command> drop(const World& world, const EdgeGrip& grip);

}  // namespace carom
