#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"
#include "terminal/panels/pages.h"

/// The start screen: groups of levels as tabs, the list of one group, and beside it a picture and a
/// few words about the selected level. It is a whole at 80x24.
namespace carom {

struct MenuEntry {
    std::string title;
    std::string line;   ///< about the level: beside the title where there is room
    std::string badge;  ///< at the right: a best score, stars, the time of an unfinished game
    bool is_broken = false;
};

/// The page as it is shown now.
struct MenuPage {
    std::vector<std::string> groups;
    std::size_t group = 0;  ///< the open one; of no meaning in a search
    std::vector<MenuEntry> entries;
    std::size_t selected = 0;
    std::string search;  ///< empty: none
    // About the selected entry:
    std::string goal;
    std::vector<std::string> notes;  ///< best scores, problems
    std::vector<PageItem> about;     ///< shown as far as there is room
    /// The height of the level's picture over its width, in cells; 0: not known yet.
    double picture_shape = 0.0;
    std::string footer;
    std::string message;  ///< stands in place of the footer, marked; empty: none
};

void draw_menu(Canvas& canvas, const MenuPage& page, const Look& look);

/// The entry under the mouse.
std::optional<std::size_t> menu_entry_at(int columns, int rows, const MenuPage& page, int column,
                                         int row);
/// The group whose tab is under the mouse.
std::optional<std::size_t> menu_group_at(int columns, const MenuPage& page, int column, int row);

/// The room for a picture of the selected level; empty in a small window.
CellArea menu_picture_area(int columns, int rows, const MenuPage& page);

}  // namespace carom
