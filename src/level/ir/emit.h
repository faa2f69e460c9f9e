#pragma once

#include "level/ir/context.h"

/// Functions that add to the intermediate representation. Shapes are given in the coordinates of
/// the frame. At the limits of a level (max_items) they report an error and throw LoadStopped.
namespace carom {

/// Counts balls, or zones that the caller is about to add, against the limit.
void reserve_balls(std::uint64_t count, const Span& at, Context& context);
void reserve_zones(std::uint64_t count, const Span& at, Context& context);
/// Starts a chain: capsules that are pieces of one edge. Returns its index.
int begin_chain(bool is_closed, Context& context, bool is_smooth = false);
void emit_capsule(const Capsule& shape, Side side, int binding, int chain, const Span& at,
                  const Frame& frame, Context& context);
int bind_edges(EdgeBinding binding, Context& context);
int name_balls(BallBinding binding, Context& context);
void emit_ball(const BallIr& ball, const Frame& frame, Context& context);

}  // namespace carom
