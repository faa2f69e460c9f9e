#pragma once

#include <optional>
#include <span>
#include <string>

#include "game/commands/command.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// Saving a level in its author's words: the text stays byte for byte, and what has changed is
/// appended, as `move`, `remove`, and statements for what was added.
namespace carom {

struct AmendedLevel {
    std::optional<std::string> text;
    /// Without a text: why the level cannot be kept so. A part of a sentence: "balls have been
    /// spawned". Then level_text (save_level.h) writes it flat.
    std::string obstacle;
};

/// `world` is the scene's world as it is now. Bodies are named as the author named them, else by
/// their number in the file (`move ball=12`). The text may still read back to other bits, since
/// what is appended may change how the author's statements are read (an added ball that lies where
/// a `fill` would put one): load it, and compare with has_same_bodies.
AmendedLevel amended_level(const Scene& scene, const World& world);

/// The level at its start, as the player has edited it: edges as they are in `world`, balls where
/// the level starts them, or where the player has added or placed them.
World edited_start(const Scene& scene, const World& world, std::span<const TimedCommand> commands);

/// Whether balls and edges are equal bit by bit, in the same order, whatever their ids, and gravity
/// is.
bool has_same_bodies(const World& a, const World& b);

}  // namespace carom
