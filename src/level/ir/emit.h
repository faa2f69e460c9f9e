#pragma once

#include "level/ir/context.h"

/// The ways into the draft, which keep the limits on how much a level makes. Shapes are in the
/// frame's coordinates.
namespace carom {

/// False when the level has too many balls; told once.
bool reserve_balls(std::uint64_t count, const Span& at, Context& context);
/// Starts a chain of capsules.
int begin_chain(bool is_closed, Context& context);
/// False when the level has too many edges; told once.
bool emit_capsule(const Capsule& shape, Side side, int binding, int chain, const Span& at,
                  const Frame& frame, Context& context);
int bind_edges(EdgeBinding binding, Context& context);
int name_balls(BallBinding binding, Context& context);
void emit_ball(const BallIr& ball, const Frame& frame, Context& context);

}  // namespace carom
