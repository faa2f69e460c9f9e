#pragma once

#include "carom/context/play_context.h"

/// The player's control of the view: drawing options, overlays, camera.
namespace carom {

void next_renderer(PlayContext& play);
void next_colors(PlayContext& play);
void next_overlay(PlayContext& play);
/// Pre: there is an overlay of that name (terminal/draw/overlays.h).
void toggle_overlay(PlayContext& play, std::string_view name);
void toggle_trails(PlayContext& play);
void toggle_ids(PlayContext& play);
void toggle_outlines(PlayContext& play);
void toggle_histogram(PlayContext& play);
void toggle_energy(PlayContext& play);
void toggle_following(PlayContext& play);
void reset_view(PlayContext& play);
void next_comparison(PlayContext& play);
void toggle_ensemble(PlayContext& play);
/// Toggles a switch of the view, and shows the message "NAME on" or "NAME off".
void toggle(PlayContext& play, bool& what, std::string_view name);
/// Zooms around the centre of the view.
void zoom(PlayContext& play, double factor);
void pan(PlayContext& play, double columns, double rows);
/// Says which key shows the whole view again.
void tell_way_back(PlayContext& play);
/// A press on empty space: the view follows the pointer until the release.
void start_panning(PlayContext& play, const InputEvent& event);

}  // namespace carom
