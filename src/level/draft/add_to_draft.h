#pragma once

#include "level/draft/context.h"

/// The ways into the draft, which keep the limits on how much a level makes. Shapes are in the
/// frame's coordinates.
namespace carom {

/// False when the level has too many balls; told once.
bool plan_balls(std::uint64_t count, const Span& at, Context& context);
/// Starts a chain of capsules.
int begin_chain(bool is_closed, Context& context);
/// False when the level has too many edges; told once.
bool add_piece(const Capsule& shape, Side side, int naming, int chain, const Span& at,
               const Frame& frame, Context& context);
int name_edges(EdgeNaming naming, Context& context);
int name_balls(BallNaming naming, Context& context);
void add_ball_draft(const BallDraft& ball, const Frame& frame, Context& context);

}  // namespace carom
