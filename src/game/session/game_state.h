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
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// What a game's rules remember beside the world: together with the world it is all that the next
/// tick depends on, so that a copy of both that goes on gives the same bits.
namespace carom {

/// One alternative a game; std::monostate where there are no rules.
using GameState = std::variant<std::monostate, PinballState, PoolPlay>;

/// At the start of the scene.
GameState begin_game(const Scene& scene);

/// Follows the rules. Pre: called after every tick of `world`, with its contacts.
void follow_rules(const Scene& scene, World& world, GameState& game,
                  std::span<const Contact> contacts);

/// As refusal(world, command), with the commands that only a game has, and what its rules forbid.
std::optional<std::string> refusal(const Scene& scene, const World& world, const GameState& game,
                                   const Command& command);
/// As obey(world, command). Pre: the command is not refused.
void obey(const Scene& scene, World& world, GameState& game, const Command& command);

/// Which buttons are down.
std::vector<Button> pressed_buttons(const GameState& game);

/// Whether the plunger is not where it rests, by a button or by hand.
bool is_plunger_pulled(const GameState& game);

/// Of both; without rules that of the world.
std::uint64_t fingerprint(const World& world, const GameState& game);

/// Beyond its own size, in bytes.
std::size_t bytes_of(const GameState& game);

/// What a report tells of it, by name: score, ball ...
std::vector<std::pair<std::string, std::uint64_t>> tallies(const GameState& game);

}  // namespace carom
