#include "level/scene/games.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace carom {
std::span<const RackLayout> rack_layouts() {
    static const std::array<RackLayout, 4> all{{
        {.statement = "rack eight",
         .rows = {1, 2, 3, 4, 5},
         .is_shuffled = true,
         .placed = {{.ball = 8, .place = 4}},
         .group_border = 8},
        {.statement = "rack nine",
         .rows = {1, 2, 3, 2, 1},
         .is_shuffled = true,
         .placed = {{.ball = 1, .place = 0}, {.ball = 9, .place = 4}},
         .group_border = 0},
        {.statement = "rack ten",
         .rows = {1, 2, 3, 4},
         .is_shuffled = true,
         .placed = {{.ball = 1, .place = 0}, {.ball = 10, .place = 4}},
         .group_border = 0},
        {.statement = "rack triangle",
         .rows = {1, 2, 3, 4, 5},
         .is_shuffled = false,
         .placed = {},
         .group_border = 0},
    }};
    return all;
}

int RackLayout::balls() const {
    return std::accumulate(rows.begin(), rows.end(), 0);
}

const RackLayout* rack_layout(std::string_view statement) {
    const auto found = std::ranges::find(rack_layouts(), statement, &RackLayout::statement);
    return found == rack_layouts().end() ? nullptr : &*found;
}

std::span<const GameRow> game_rows() {
    using enum GameRow::Family;
    static const std::array<GameRow, 10> all{{
        {.name = "sandbox"},
        {.name = "galton"},
        {.name = "eightball", .family = pool, .rack = rack_layout("rack eight")},
        {.name = "nineball",
         .family = pool,
         .rack = rack_layout("rack nine"),
         .keys = {"fouls", "nine"}},
        {.name = "tenball", .family = pool, .rack = rack_layout("rack ten"), .keys = {"fouls"}},
        {.name = "straightpool",
         .family = pool,
         .rack = rack_layout("rack triangle"),
         .keys = {"fouls", "points"}},
        {.name = "onepocket",
         .family = pool,
         .rack = rack_layout("rack triangle"),
         .keys = {"fouls"}},
        {.name = "snooker",
         .family = pool,
         .rack = rack_layout("rack triangle"),
         .others = {"yellow", "green", "brown", "blue", "pink", "black"}},
        {.name = "pinball", .family = pinball},
        {.name = "shots", .family = shots, .keys = {"players", "wins", "stroke", "settle"}},
    }};
    return all;
}

const GameRow* game_named(std::string_view name) {
    const auto found = std::ranges::find(game_rows(), name, &GameRow::name);
    return found == game_rows().end() ? nullptr : &*found;
}

std::string game_names(std::string_view separator) {
    std::string names;
    for (const GameRow& game : game_rows()) {
        if (!names.empty()) names += separator;
        names += game.name;
    }
    return names;
}

}  // namespace carom
