#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The games that a level can name, and their racks: one row each.
namespace carom {

/// How the statement `rack NAME` places balls.
struct RackLayout {
    std::string_view statement;  ///< "rack eight"
    std::vector<int> rows;       ///< balls in each row, the apex first
    /// Whether a seed shuffles the balls, except those that the rules place.
    bool is_shuffled = false;
    /// A ball that the rules place, and where: positions count row by row from 0.
    struct Placed {
        int ball = 0;
        int place = 0;
    };
    std::vector<Placed> placed;
    /// Balls below this number and balls above it form two groups, and each group has one ball in a
    /// rear corner; 0: there are no groups.
    int group_border = 0;

    int balls() const;
};

std::span<const RackLayout> rack_layouts();
/// The layout of a statement, by its full name; null if there is none.
const RackLayout* rack_layout(std::string_view statement);

struct GameRow {
    enum class Family : std::uint8_t {
        none,
        pinball,
        pool,  ///< a referee judges it
        shots  ///< the level's own rules judge it (scene/rules.h)
    };

    std::string_view name;  ///< its name in levels: "eightball"
    Family family = Family::none;
    const RackLayout* rack = nullptr;  ///< the rack of a game of pool; null in other games
    /// The names of the other object balls, which the level places one by one. They are numbered
    /// after those of the rack.
    std::vector<std::string_view> others{};
    /// Keys of `game NAME` that only some games of pool have; race=, clock= and the like go with
    /// every one.
    std::vector<std::string_view> keys{};
};

/// All games, in the order of the manual.
std::span<const GameRow> game_rows();
/// The game of this name; null if there is none.
const GameRow* game_named(std::string_view name);

/// All names, separated by `separator`.
std::string game_names(std::string_view separator);

}  // namespace carom
