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
#include "terminal/panels/hud.h"

/// Pages that fill the window: help, text, and the message for a window that is too small. The menu
/// is in menu.h.
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

/// Draws as many of the first paragraphs and entries as the area has room for, none of them in
/// part.
void draw_items(Canvas& canvas, const CellArea& area, std::span<const PageItem> items,
                const Look& look);

}  // namespace carom
