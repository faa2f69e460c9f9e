#pragma once

#include "game/ai/planner.h"
#include "game/session/session.h"
#include "terminal/draw/pool_annotations.h"

/// Draws a shot before it is made.
namespace carom {

/// The cue behind a ball, from its tip to its butt, further back for a harder shot.
/// Pre: `velocity` is not zero.
PoolAnnotations::Line stick_behind(const Disc& ball, Vec2 velocity);
/// Draws the opponent's shot before the stroke: the cue, its line to the first ball,
/// and the pocket. A cue ball that is yet to be placed is drawn as a ghost ball, without a line.
void show_shot(const Session& session, const CandidateShot& shot, PoolAnnotations& annotations);

}  // namespace carom
