#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "game/commands/command.h"
#include "game/pinball/pinball_state.h"
#include "game/pool/pool.h"
#include "game/shots/goal_play.h"
#include "game/shots/shots.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/fingerprint.h"
#include "physics/world/world.h"

/// The state of a game's rules, besides the world. Together they determine the next tick
/// completely, so a copy of both continues with the same bits.
namespace carom {

/// One alternative for each family of games; std::monostate without rules.
using GameState = std::variant<std::monostate, PinballState, PoolPlay, ShotsState, GoalPlay>;

/// The state at the start of the scene.
GameState begin_game(const Scene& scene);

/// Applies the rules to the results of a tick. Pre: called after every tick of `world`, with its
/// contacts.
void update_game(const Scene& scene, World& world, GameState& game,
                 std::span<const Contact> contacts);

/// Whether all positions in the command are within 1,000 times the view's size of the view. No
/// pointer gets further, and a hand that moved there in a tick would sweep the whole scene.
bool is_within_reach(const Scene& scene, const Command& command);

/// refusal(world, command), extended by is_within_reach and by the commands and the rules of the
/// game.
std::optional<std::string> refusal(const Scene& scene, const World& world, const GameState& game,
                                   const Command& command);
/// execute(world, command), extended by the commands of the game. Pre: the command is not refused.
void execute(const Scene& scene, World& world, GameState& game, const Command& command);

/// The buttons that are down.
std::vector<Button> pressed_buttons(const GameState& game);

/// Whether the plunger is pulled, by a button or by hand.
bool is_plunger_pulled(const GameState& game);

/// The fingerprint of world and rules; without rules that of the world.
std::uint64_t fingerprint(const World& world, const GameState& game,
                          int version = fingerprint_version);

/// The memory that the state owns, without sizeof, in bytes.
std::size_t bytes_of(const GameState& game);

/// The numbers that reports list, by name: score, ball, ...
std::vector<std::pair<std::string, std::int64_t>> tallies(const GameState& game);

/// The variables of the level's rules: of each player in turn, or one value. In their order.
std::vector<std::pair<std::string, std::vector<std::int64_t>>> variables(const Scene& scene,
                                                                         const GameState& game);

/// The state of the level's rules; null: it has none.
const RuleState* rule_state(const GameState& game);
/// The state of the level's goal; null: it has none.
const GoalState* goal_state(const GameState& game);
/// The stars of a goal that is reached, 0 to most_stars.
int stars_of(const GameState& game);
/// What to do now, in a line, by the rules of the level; empty: they do not say.
std::string task_text(const Scene& scene, const World& world, const GameState& game);

}  // namespace carom
