#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Pinball: the mechanisms of a table between two ticks, and the rules
/// (level/scene/pinball_table.h). In a level without `game pinball` the mechanisms work too, but
/// there are no rules and no count of balls.
namespace carom {

PinballState begin_pinball(const Scene& scene);

/// Applies mechanisms and rules to the results of a tick. Pre: the tick has just been computed, and
/// these are its contacts.
void update_pinball(const Scene& scene, World& world, PinballState& state,
                    std::span<const Contact> contacts);

/// Whether this button moves anything on the table.
bool has_button(const Scene& scene, Button button);

/// Presses or releases a button. It takes effect in the next tick.
void press(const Scene& scene, World& world, PinballState& state, Button button, bool is_down);

/// Pulls the plunger by hand instead of by its button: to this share of its travel, 0..1; releases
/// it there if `lets_go`.
void pull_plunger(const Scene& scene, World& world, PinballState& state, double share,
                  bool lets_go);

/// The task that the rules of the table show now (`task` in a level); empty: none.
std::string task_text(const Scene& scene, const World& world, const PinballState& state);

/// The groups of devices to shoot for now (`task ... for`), which flash.
std::span<const std::uint32_t> shots_to_make(const Scene& scene, const World& world,
                                             const PinballState& state);

/// Whether another player may join: during the first ball, as many as the level allows.
bool may_join(const Scene& scene, const PinballState& state);
/// The scores of all players.
std::vector<std::int64_t> scores_of(const PinballState& state);

/// Whether the ball is shut in, so that it never drains.
bool is_captive(const Scene& scene, BallId ball);
/// Whether the ball can drain: it is neither captive nor locked.
bool is_in_play(const Scene& scene, const PinballState& state, BallId ball);

/// Whether a ball lies on a plunger.
bool is_on_plunger(const Scene& scene, const World& world);

}  // namespace carom
