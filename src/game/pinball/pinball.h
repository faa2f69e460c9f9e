#pragma once

#include <span>

#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Pinball: what its mechanisms do between two ticks, and its rules (level/table.h). A level that
/// has mechanisms but no `game pinball` has no balls to count and no rules; they work all the same.
namespace carom {

PinballState begin_pinball(const Scene& scene);

/// What a tick has brought about. Pre: the tick has just been computed, and these are its contacts.
void follow_pinball(const Scene& scene, World& world, PinballState& state,
                    std::span<const Contact> contacts);

/// Whether the table has anything that this button moves.
bool has_button(const Scene& scene, Button button);

/// A button goes down or up. It acts from the next tick on.
void press(const Scene& scene, World& world, PinballState& state, Button button, bool is_down);

/// A hand takes the plunger from its button, holds it at this share of its way, 0..1, and may let
/// go of it there.
void pull_plunger(const Scene& scene, World& world, PinballState& state, double share,
                  bool lets_go);

/// Whether a ball lies on the plunger.
bool is_on_plunger(const Scene& scene, const World& world);

}  // namespace carom
