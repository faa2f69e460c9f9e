#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"
#include "terminal/canvas/renderer.h"

/// The panel of a pool table: who plays which balls, the score, the tray of pocketed balls, and
/// where the tip strikes.
namespace carom {

struct PoolPanel {
    struct Player {
        std::string name;
        std::string group;        ///< "solids"; empty: not decided, or the game has none
        std::vector<int> left;    ///< numbers of its balls on the table
        std::int64_t frames = 0;  ///< or the score of a game that has no frames
        bool is_turn = false;
    };
    std::optional<std::array<Player, 2>> players;  ///< none: no game is played
    std::uint32_t race = 0;                        ///< frames that win; 0: no end
    std::vector<int> tray;                         ///< numbers of the pocketed balls
    struct Tip {
        double side = 0.0;    ///< -1 to 1, to the right
        double follow = 0.0;  ///< -1 to 1, up
    };
    std::optional<Tip> tip;
};

/// Takes the room for the panel from `area`: a strip at the top, where a table of this shape (width
/// over height) leaves rows free, or a column at the right. Nothing in a small window.
CellArea cut_pool_panel(CellArea& area, double table_shape, double aspect);

void draw_pool_panel(Canvas& canvas, const CellArea& area, const PoolPanel& panel,
                     const Renderer& renderer, double aspect, const Look& look);

}  // namespace carom
