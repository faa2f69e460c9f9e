#pragma once

#include <optional>
#include <vector>

#include "game/commands/command.h"
#include "geometry/shapes.h"
#include "physics/world/world.h"

/// Picking: the ball or edge under the pointer, and the dragging of edges. Lengths are in the units
/// of the world. On a torus (Model::wrap) distances are to the nearest image. Ties go to the lower
/// id. Cost of each query: one pass over all bodies.
namespace carom {

/// The vector from `a` to `b`; on a torus the shortest one.
Vec2 offset(const World& world, Vec2 a, Vec2 b);

/// The ball nearest to `point`, at most `slack` away from it. If several discs contain the point,
/// the one with the nearest centre. None if no ball is near enough.
std::optional<BallId> ball_at(const World& world, Vec2 point, double slack);

/// One end of an edge.
struct EdgeEnd {
    CapsuleId capsule{};
    bool is_end = false;  ///< Capsule::end; else Capsule::start

    friend bool operator==(const EdgeEnd&, const EdgeEnd&) = default;
};

Vec2 position(const World& world, const EdgeEnd& end);

/// The edge end whose round cap is nearest to `point`, at most `slack` away.
std::optional<EdgeEnd> edge_end_at(const World& world, Vec2 point, double slack);

/// The edge nearest to `point`, at most `slack` away from its surface; inside counts as 0.
std::optional<CapsuleId> edge_at(const World& world, Vec2 point, double slack);

/// All edge ends at exactly the position of this one, including it: the joint of a polyline, which
/// moves as one. In ascending order of id, start before end.
std::vector<EdgeEnd> joint(const World& world, const EdgeEnd& end);

/// The next (or previous) ball after `from`, cyclic by id; the first (or last) if `from` does not
/// exist. None without balls.
std::optional<BallId> next_ball(const World& world, std::optional<BallId> from,
                                bool backwards = false);

/// The edge ends that a drag moves. Their offsets from the pointer stay fixed.
struct EdgeGrip {
    struct Part {
        CapsuleId capsule{};
        Vec2 start;  ///< positions of the ends when they were grabbed
        Vec2 end;
        bool moves_start = false;
        bool moves_end = false;
    };
    std::vector<Part> parts;  ///< ascending by capsule
    Vec2 taken_at;
};

/// Grabs the joint that `end` belongs to. A peg, which has both ends there, moves as a whole. Pre:
/// the edge exists.
EdgeGrip grip_joint(const World& world, const EdgeEnd& end, Vec2 hand);

/// Grabs a whole edge; edges joined to it follow. Pre: the edge exists.
EdgeGrip grip_edge(const World& world, CapsuleId capsule, Vec2 hand);

/// The commands that drag, place or release: one for each grabbed edge that still exists. `place`
/// is for a paused world.
std::vector<Command> carry(const World& world, const EdgeGrip& grip, Vec2 hand);
std::vector<Command> place(const World& world, const EdgeGrip& grip, Vec2 hand);
std::vector<Command> drop(const World& world, const EdgeGrip& grip);

}  // namespace carom
