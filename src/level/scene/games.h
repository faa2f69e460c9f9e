#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The games that a level can name, and how their balls are racked: one row each.
namespace carom {

/// How the statement `rack NAME` places balls.
struct RackLayout {
    std::string_view statement;  ///< "rack eight"
    std::vector<int> rows;       ///< balls in each row, the apex first
    /// Whether a seed puts the balls in random order, but for those that the rules place.
    bool is_shuffled = false;
    /// A ball that the rules place, and where: places count row by row from 0.
    struct Placed {
        int ball = 0;
        int place = 0;
    };
    std::vector<Placed> placed;
    /// Balls below this number and balls above it form two groups, of which each has one ball in a
    /// rear corner; 0: there are no groups.
    int group_border = 0;

    int balls() const;
};

std::span<const RackLayout> rack_layouts();
/// By the whole name of the statement; null when there is none.
const RackLayout* rack_layout(std::string_view statement);

struct GameRow {
    enum class Family : std::uint8_t { none, pinball, pool };

    std::string_view name;  ///< as levels name it: "eightball"
    Family family = Family::none;
    const RackLayout* rack = nullptr;  ///< what a game of pool begins with; null in other games
};

/// In the order in which the manual lists them.
std::span<const GameRow> game_rows();
/// Null when there is no such game.
const GameRow* game_named(std::string_view name);

/// Every name with `separator` between.
std::string game_names(std::string_view separator);

}  // namespace carom
