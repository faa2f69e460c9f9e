#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "game/commands/command.h"
#include "game/shots/shots_state.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// `game shots`: players take shots in turn, and the rules of the level judge them
/// (level/scene/rules.h).
///
/// A shot begins with a strike and ends in the first tick in which all balls are at rest, or have
/// been for RuleBook::settle. Then `shot ends` happens, then `shot judged`, and then what the rules
/// have decided: the game ends, or the turn passes, or the same player shoots again. A cue ball
/// that is off the table returns to its start before its player shoots.
namespace carom {

/// None unless the level says `game shots`.
std::optional<ShotsState> begin_shots(const Scene& scene);

/// Applies the rules to the results of a tick. Pre: called after every tick of `world`, with its
/// contacts.
void update_shots(const Scene& scene, World& world, ShotsState& state,
                  std::span<const Contact> contacts);

/// The cue of the player whose turn it is.
const Cue& cue_in_turn(const Scene& scene, const ShotsState& state);
/// The ball that it strikes, by number; where the player chooses, the last one chosen.
std::uint32_t cue_of(const Scene& scene, const ShotsState& state);
/// The ball itself; none: it is off the table.
std::optional<BallId> cue_ball_of(const Scene& scene, const ShotsState& state);
/// The balls on the table that the player may strike now, in the order of the level.
std::vector<BallId> cue_balls_of(const Scene& scene, const ShotsState& state);

/// Why the player cannot shoot now, as a sentence; none: it can.
std::optional<std::string> refusal_to_shoot(const World& world, const ShotsState& state);
/// Why a command is against the rules, or cannot be executed by the world; none if it can. A player
/// may strike its cue ball, place it when it is in hand, and start the game anew; nothing else.
std::optional<std::string> refusal(const Scene& scene, const World& world, const ShotsState& state,
                                   const Command& command);
/// Pre: not refused.
void execute(const Scene& scene, World& world, ShotsState& state, const Command& command);

/// What a cue strikes: the name of its ball; of several, that of their kind.
std::string cue_name(const Scene& scene, const Cue& cue);
/// "3 : 5, player 2 shoots (yellow)"; who won, where the game is over.
std::string turn_text(const Scene& scene, const ShotsState& state);
/// The task that the rules show now (`task` in a level); else the goal; empty: neither.
std::string task_text(const Scene& scene, const World& world, const ShotsState& state);

/// The part of the table that the rules want to be seen; none: all of it.
std::optional<Box> box_to_look_at(const Scene& scene, const ShotsState& state);

/// The digest of the whole state, combined with `start`.
std::uint64_t digest_of(std::uint64_t start, const ShotsState& state);
/// The memory that the state owns, without sizeof, in bytes.
std::size_t bytes_of(const ShotsState& state);

}  // namespace carom
