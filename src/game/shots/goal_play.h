#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "game/commands/command.h"
#include "game/rules/goal.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// A level with a goal and without a game: everything is allowed, and the goal is watched.
///
/// A goal that counts shots counts strikes of the cue. An attempt in which a hand, too, moved
/// something does not count: the player restarts the level. A goal that counts seconds is for
/// levels that are played with the hands, so there everything counts.
namespace carom {

struct GoalPlay {
    RuleState rules;
    GoalState goal;
    bool is_void = false;  ///< a hand has helped

    friend bool operator==(const GoalPlay&, const GoalPlay&) = default;
};

/// None: the level has a game, or no goal.
std::optional<GoalPlay> begin_goal(const Scene& scene);

/// Pre: called after every tick of `world`.
void update_goal(const Scene& scene, const World& world, GoalPlay& play);

/// Executes a command. Pre: it is not refused.
void execute(const Scene& scene, World& world, GoalPlay& play, const Command& command);

/// The goal, and how far it is.
std::string task_text(const Scene& scene, const GoalPlay& play);

/// The digest of the whole state, combined with `start`.
std::uint64_t digest_of(std::uint64_t start, const GoalPlay& play);

}  // namespace carom
