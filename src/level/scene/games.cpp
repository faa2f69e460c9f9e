#include "level/scene/games.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace carom {
std::span<const RackLayout> rack_layouts() {
    static const std::array<RackLayout, 3> all{{
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
    static const std::array<GameRow, 5> all{{
        {"sandbox", none, nullptr},
        {"galton", none, nullptr},
        {"eightball", pool, rack_layout("rack eight")},
        {"nineball", pool, rack_layout("rack nine")},
        {"pinball", pinball, nullptr},
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
