#pragma once

#include "level/ir/arguments.h"
#include "level/ir/emit.h"

/// Statements to the draft: one function a statement that makes something, one for all that only
/// declare. Pre, for each: arguments.is_valid. Everything passes through the frame's transform.
namespace carom {

// Shapes (shapes.cpp).
void build_edge(const Arguments& arguments, const Frame& frame, Context& context);
void build_arc(const Arguments& arguments, const Frame& frame, Context& context);
void build_peg(const Arguments& arguments, const Frame& frame, Context& context);
void build_box(const Arguments& arguments, const Frame& frame, Context& context);

// Balls and where they come from (ball_parts.cpp).
void build_ball(const Arguments& arguments, const Frame& frame, Context& context);
void build_spawn(const Arguments& arguments, const Frame& frame, Context& context);
void build_fill(const Arguments& arguments, const Frame& frame, Context& context);
void build_cradle(const Arguments& arguments, const Frame& frame, Context& context);

// Galton's board (galton_parts.cpp).
void build_pegs(const Arguments& arguments, const Frame& frame, Context& context);
void build_bins(const Arguments& arguments, const Frame& frame, Context& context);
void build_zone(const Arguments& arguments, const Frame& frame, Context& context);

// What stands on a pinball table (pinball_parts.cpp).
void build_flipper(const Arguments& arguments, const Frame& frame, Context& context);
void build_bumper(const Arguments& arguments, const Frame& frame, Context& context);
/// slingshot, droptarget, target and gate: one for each two points.
void build_device_edges(const Arguments& arguments, const Frame& frame, Context& context);
/// rollover, spinner, kickback, hole and lamp: one for each place.
void build_device_spots(const Arguments& arguments, const Frame& frame, Context& context);
void build_ramp(const Arguments& arguments, const Frame& frame, Context& context);
void build_plunger(const Arguments& arguments, const Frame& frame, Context& context);
void build_drain(const Arguments& arguments, const Frame& frame, Context& context);

// A pool table (pool_parts.cpp).
void build_rack(const Arguments& arguments, const Frame& frame, Context& context);
void build_pocket(const Arguments& arguments, const Frame& frame, Context& context);
void declare_cue(const Arguments& arguments, Context& context);
void declare_cloth(const Arguments& arguments, Context& context);

// Drawings (map_drawing.cpp).

/// What a letter of a drawing stands for.
struct Legend {
    enum class What { ball, peg, solid };
    What what = What::ball;
    std::optional<Word> kind;
    std::optional<Word> material;
    std::optional<double> radius;
    Vec2 velocity;
};
using Legends = std::map<std::string, Legend, std::less<>>;
void build_map(const Arguments& arguments, const Legends& legends, const Frame& frame,
               Context& context);

/// Carries out the statements that only declare: use, kind, rate, show ... (declarations.cpp)
/// `world`, `units`, `let`, blocks and includes are not among them. False: it is none of them.
bool declare(const Arguments& arguments, const Scope& scope, Legends& legends, Context& context);

}  // namespace carom
