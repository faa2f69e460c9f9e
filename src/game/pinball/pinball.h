#pragma once

#include <span>

#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Pinball: what the mechanisms of a table do between two ticks, and the rules
/// (level/scene/pinball_table.h). The mechanisms of a level without `game pinball` work too, but
/// there are no rules and no balls to count.
namespace carom {

PinballState begin_pinball(const Scene& scene);

/// Applies mechanisms and rules to what the tick did. Pre: the tick has just been computed, and
/// these are its contacts.
void update_pinball(const Scene& scene, World& world, PinballState& state,
                    std::span<const Contact> contacts);

/// Whether the table has anything that this button moves.
bool has_button(const Scene& scene, Button button);

/// Presses or releases a button. It acts from the next tick on.
void press(const Scene& scene, World& world, PinballState& state, Button button, bool is_down);

/// Pulls the plunger by hand instead of by its button: to this share of its travel, 0..1, and
/// releases it there if `lets_go`.
void pull_plunger(const Scene& scene, World& world, PinballState& state, double share,
                  bool lets_go);

/// Whether a ball lies on a plunger.
bool is_on_plunger(const Scene& scene, const World& world);

}  // namespace carom
