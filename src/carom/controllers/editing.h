#pragma once

#include "carom/context/play_context.h"

/// Editing of balls and edges at the pointer, with keys.
namespace carom {

/// Moves the cursor to the next ball by id, and selects it.
void select_ball(PlayContext& play, bool backwards);
/// Grabs the object at the pointer; with an object in hand, drops it, shoots, or makes the edge.
void grab(PlayContext& play);
/// Completes what the hand does: drops, shoots, or makes the edge. False: it cannot, and the player
/// was told why.
bool open_hand(PlayContext& play);
/// Puts the cue on the ball at the pointer, or puts the cue away.
void use_cue(PlayContext& play);
/// Adds a copy of the selected ball at the pointer.
void add_ball_at_pointer(PlayContext& play);
/// Removes the ball at the pointer, else the edge; `only_edges`: the edge only.
void remove_at_pointer(PlayContext& play, bool only_edges);
/// Starts an edge at the pointer, or completes it there.
void draw_edge(PlayContext& play);
/// Undoes the last command. False: there is none.
bool undo(PlayContext& play);

}  // namespace carom
