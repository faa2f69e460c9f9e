#pragma once

#include "level/ir/context.h"

/// Functions that add to the intermediate representation and enforce its limits. Shapes are given
/// in the coordinates of the frame.
namespace carom {

/// Reserves room for balls. False: the level has too many, which is reported once.
bool reserve_balls(std::uint64_t count, const Span& at, Context& context);
/// Starts a chain: capsules that are pieces of one edge. Returns its index.
int begin_chain(bool is_closed, Context& context);
/// Adds a capsule. False: the level has too many, which is reported once.
bool emit_capsule(const Capsule& shape, Side side, int binding, int chain, const Span& at,
                  const Frame& frame, Context& context);
int bind_edges(EdgeBinding binding, Context& context);
int name_balls(BallBinding binding, Context& context);
void emit_ball(const BallIr& ball, const Frame& frame, Context& context);

}  // namespace carom
