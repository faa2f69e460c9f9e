#pragma once

#include "carom/context/play_context.h"

/// What the player does to balls and edges with keys, at the pointer.
namespace carom {

/// Moves the cursor to the next ball by id, and selects it.
void select_ball(PlayContext& play, bool backwards);
/// Takes what is at the pointer; with something in hand, drops it, shoots, or makes the edge.
void grab(PlayContext& play);
/// Puts the cue on the ball at the pointer, or puts it away.
void use_cue(PlayContext& play);
/// Adds a ball like the selected one.
void add_ball_at_pointer(PlayContext& play);
/// Removes the ball at the pointer, else the edge; `only_edges`: the edge.
void remove_at_pointer(PlayContext& play, bool only_edges);
/// Starts an edge at the pointer, or ends it there.
void draw_edge(PlayContext& play);
/// Takes the last command back. False: there is none.
bool undo(PlayContext& play);

}  // namespace carom
