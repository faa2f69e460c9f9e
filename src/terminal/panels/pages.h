#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"
#include "terminal/panels/hud.h"

/// Pages that fill the window: the menu, help, a text, and the message for a window that is too
/// small.
namespace carom {

/// Smaller windows show nothing but a request for more room.
inline constexpr int least_columns = 20;
inline constexpr int least_rows = 8;
bool is_too_small(int columns, int rows);
void draw_too_small(Canvas& canvas);

struct HelpSection {
    std::string title;
    std::vector<KeyHelp> keys;
};

/// How far a page can be scrolled, in rows: 0 when all of it is visible.
struct PageExtent {
    int scroll = 0;  ///< in use: the requested position, clamped
    int most = 0;
};

/// Draws help in no more columns than it needs to be seen as a whole. `footer` says how to leave.
PageExtent draw_help(Canvas& canvas, std::span<const HelpSection> sections, int scroll,
                     std::string_view footer, const Look& look);

/// Draws lines of text (the errors of a level, a message), wrapped at the window's edge.
PageExtent draw_text_page(Canvas& canvas, std::string_view title,
                          std::span<const std::string> lines, int scroll, std::string_view footer,
                          const Look& look);

/// A paragraph, an entry of a list (with `left`), or, if both are empty, a blank line.
struct PageItem {
    std::string left;
    std::string text;
};

/// Draws paragraphs and lists; `goal` stands first, marked, and may be empty.
PageExtent draw_about(Canvas& canvas, std::string_view title, std::string_view goal,
                      std::span<const PageItem> items, int scroll, std::string_view footer,
                      const Look& look);

struct MenuEntry {
    std::string name;                  ///< "galton"
    std::string title;                 ///< of the level
    std::string group;                 ///< a heading is drawn where the group changes
    std::vector<std::string> preview;  ///< the level's opening comment
    bool is_broken = false;
};

/// Draws the list with the selected entry in view and, beside it (below it in a narrow window), a
/// description of the entry.
void draw_menu(Canvas& canvas, std::span<const MenuEntry> entries, std::size_t selected,
               std::string_view footer, const Look& look);

/// The entry under the mouse.
std::optional<std::size_t> menu_entry_at(int columns, int rows, std::span<const MenuEntry> entries,
                                         std::size_t selected, int column, int row);

/// The room for a small picture of the selected level; empty in a small window.
CellArea menu_picture_area(int columns, int rows, std::span<const MenuEntry> entries,
                           std::size_t selected);

}  // namespace carom
