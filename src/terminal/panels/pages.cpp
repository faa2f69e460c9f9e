#include "terminal/panels/pages.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/panel.h"

namespace carom {

namespace {

// One line of a page.
struct Line {
    std::string left;  ///< a key, in strong ink; may be empty
    int indent = 0;    ///< the column where `text` starts
    std::string text;
    Ink ink;
};

void write_centered(Canvas& canvas, int row, std::string_view text, const Ink& ink) {
    const int column = std::max(0, (canvas.columns() - columns_of(text)) / 2);
    canvas.write(column, row, text, ink.color, default_color, ink.attributes);
}

// The footer in the last row; at its right, the position in a scrolled page.
void draw_footer(Canvas& canvas, std::string_view footer, const PageExtent& extent,
                 const Look& look) {
    const int row = canvas.rows() - 1;
    const Ink faint = ink_of(Role::faint, look);
    canvas.write(1, row, footer, faint.color, default_color, faint.attributes);
    if (extent.most == 0) return;
    const std::string_view where = extent.scroll == 0            ? " down: more below "
                                   : extent.scroll < extent.most ? " up, down: more "
                                                                 : " up: more above ";
    canvas.write(canvas.columns() - columns_of(where), row, where, faint.color, default_color,
                 static_cast<std::uint8_t>(faint.attributes | reverse));
}

PageExtent extent_of(int lines, int room, int scroll) {
    const int most = std::max(0, lines - std::max(0, room));
    return {std::clamp(scroll, 0, most), most};
}

int key_width(std::span<const HelpSection> sections) {
    int width = 0;
    for (const HelpSection& section : sections) {
        for (const KeyHelp& key : section.keys)
            width = std::max(width, columns_of(key.keys));
    }
    return width;
}

// The lines of one section, no wider than `columns`.
std::vector<Line> lines_of(const HelpSection& section, int keys, int columns, const Look& look) {
    std::vector<Line> lines;
    lines.push_back({"", 0, section.title, ink_of(Role::warning, look)});
    const int indent = std::min(keys + 2, columns / 2);
    for (const KeyHelp& key : section.keys) {
        std::string left = key.keys;
        if (columns_of(left) >= indent) {
            lines.push_back({std::move(left), indent, "", {}});
            left.clear();
        }
        for (std::string& text : wrapped(key.what, columns - indent)) {
            lines.push_back({left, indent, std::move(text), ink_of(Role::text, look)});
            left.clear();
        }
    }
    lines.push_back({});
    return lines;
}

void draw_line(Canvas& canvas, int column, int row, const Line& line, const Look& look) {
    const Ink strong = ink_of(Role::strong, look);
    canvas.write(column, row, line.left, strong.color, default_color, strong.attributes);
    canvas.write(column + line.indent, row, line.text, line.ink.color, default_color,
                 line.ink.attributes);
}

// Paragraphs and entries of a list, no wider than `columns`.
std::vector<Line> lines_of(std::span<const PageItem> items, int columns, const Look& look) {
    int keys = 0;
    for (const PageItem& item : items)
        keys = std::max(keys, columns_of(item.left));
    const Ink ink = ink_of(Role::text, look);
    std::vector<Line> lines;
    for (const PageItem& item : items) {
        const int indent = item.left.empty() ? 0 : std::min(keys + 2, columns / 2);
        std::string left = item.left;
        if (columns_of(left) >= indent && !left.empty()) {
            lines.push_back({std::move(left), indent, "", {}});
            left.clear();
        }
        if (item.text.empty()) lines.push_back({});
        for (std::string& part : wrapped(item.text, columns - indent)) {
            if (item.text.empty()) break;
            lines.push_back({std::move(left), indent, std::move(part), ink});
            left.clear();
        }
    }
    return lines;
}

using HelpColumns = std::vector<std::vector<Line>>;

// Whole sections in `count` columns of at most `height` rows; a section that does not fit goes on
// in the next column, and the last column takes what is left.
HelpColumns columns_of_sections(std::span<const HelpSection> sections, int keys, int count,
                                int width, int height, const Look& look) {
    HelpColumns columns(1);
    const auto room = static_cast<std::size_t>(std::max(1, height));
    for (const HelpSection& section : sections) {
        std::vector<Line> part = lines_of(section, keys, width, look);
        const bool is_full =
            !columns.back().empty() && columns.back().size() + part.size() - 1 > room;
        if (is_full && columns.size() < static_cast<std::size_t>(count)) columns.emplace_back();
        std::move(part.begin(), part.end(), std::back_inserter(columns.back()));
    }
    return columns;
}

// The blank line that ends a column needs no room.
int height_of(const HelpColumns& columns) {
    std::size_t longest = 1;
    for (const auto& column : columns)
        longest = std::max(longest, column.size());
    return static_cast<int>(longest) - 1;
}

// The columns of the least height.
HelpColumns balanced_columns(std::span<const HelpSection> sections, int keys, int count, int width,
                             const Look& look) {
    const int all = height_of(columns_of_sections(sections, keys, 1, width, 1, look));
    for (int height = (all + count - 1) / count;; ++height) {
        HelpColumns columns = columns_of_sections(sections, keys, count, width, height, look);
        if (height_of(columns) <= height || height >= all) return columns;
    }
}

int text_width(std::span<const HelpSection> sections) {
    int width = 0;
    for (const HelpSection& section : sections) {
        width = std::max(width, columns_of(section.title));
        for (const KeyHelp& key : section.keys)
            width = std::max(width, columns_of(key.what));
    }
    return width;
}

}  // namespace

bool is_too_small(int columns, int rows) {
    return columns < least_columns || rows < least_rows;
}

void draw_too_small(Canvas& canvas) {
    canvas.fill({});
    const std::array lines = {std::string("too small"),
                              std::to_string(canvas.columns()) + "x" +
                                  std::to_string(canvas.rows()) + " < " +
                                  std::to_string(least_columns) + "x" + std::to_string(least_rows),
                              std::string("make it larger")};
    const int first = std::max(0, (canvas.rows() - static_cast<int>(lines.size())) / 2);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        write_centered(canvas, first + static_cast<int>(i), lines[i], {default_color, plain});
    }
}

PageExtent draw_help(Canvas& canvas, std::span<const HelpSection> sections, int scroll,
                     std::string_view footer, const Look& look) {
    canvas.fill({});
    constexpr int least_width = 36;
    constexpr int between = 3;
    constexpr int most_columns = 4;
    const int room = canvas.columns() - 2;
    const int rows = canvas.rows() - 1;
    const int keys = key_width(sections);
    const int natural = std::max(least_width, keys + 2 + text_width(sections));
    // As few columns as show everything; else as many as fit.
    const int most = std::clamp((room + between) / (least_width + between), 1, most_columns);
    HelpColumns columns;
    int width = 0;
    for (int count = 1; count <= most; ++count) {
        width = std::min(natural, (room + between) / count - between);
        columns = balanced_columns(sections, keys, count, width, look);
        if (height_of(columns) <= rows) break;
    }
    const PageExtent extent = extent_of(height_of(columns), rows, scroll);
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const int left = 1 + static_cast<int>(c) * (width + between);
        for (int row = 0; row < rows; ++row) {
            const auto line = static_cast<std::size_t>(row + extent.scroll);
            if (line < columns[c].size()) draw_line(canvas, left, row, columns[c][line], look);
        }
    }
    draw_footer(canvas, footer, extent, look);
    return extent;
}

PageExtent draw_about(Canvas& canvas, std::string_view title, std::string_view goal,
                      std::span<const PageItem> items, int scroll, std::string_view footer,
                      const Look& look) {
    canvas.fill({});
    constexpr int widest = 76;  // a line that the eye can follow
    const int columns = std::min(widest, canvas.columns() - 2);
    std::vector<Line> lines;
    if (!goal.empty()) {
        const PageItem first{"Goal", std::string(goal)};
        lines = lines_of(std::span(&first, 1), columns, look);
        for (Line& line : lines)
            line.ink = ink_of(Role::warning, look);
        lines.push_back({});
    }
    std::ranges::move(lines_of(items, columns, look), std::back_inserter(lines));
    const Ink strong = ink_of(Role::strong, look);
    canvas.write(1, 0, title, strong.color, default_color, strong.attributes);
    constexpr int first_row = 2;
    const int rows = canvas.rows() - first_row - 1;
    const PageExtent extent = extent_of(static_cast<int>(lines.size()), rows, scroll);
    for (int row = 0; row < rows; ++row) {
        const auto line = static_cast<std::size_t>(row + extent.scroll);
        if (line < lines.size()) draw_line(canvas, 1, first_row + row, lines[line], look);
    }
    draw_footer(canvas, footer, extent, look);
    return extent;
}

void draw_items(Canvas& canvas, const CellArea& area, std::span<const PageItem> items,
                const Look& look) {
    for (std::size_t count = items.size(); count > 0; --count) {
        // A heading without what it announces says nothing.
        if (count < items.size() && items[count - 1].text.ends_with(':')) continue;
        const std::vector<Line> lines = lines_of(items.first(count), area.columns, look);
        if (static_cast<int>(lines.size()) > area.rows) continue;
        for (std::size_t i = 0; i < lines.size(); ++i)
            draw_line(canvas, area.column, area.row + static_cast<int>(i), lines[i], look);
        return;
    }
}

PageExtent draw_text_page(Canvas& canvas, std::string_view title,
                          std::span<const std::string> lines, int scroll, std::string_view footer,
                          const Look& look) {
    canvas.fill({});
    std::vector<std::string> broken;
    for (const std::string& line : lines) {
        for (std::string& part : wrapped(line, canvas.columns() - 2)) {
            broken.push_back(std::move(part));
        }
    }
    const Ink strong = ink_of(Role::strong, look);
    canvas.write(1, 0, title, strong.color, default_color, strong.attributes);
    constexpr int first_row = 2;
    const int rows = canvas.rows() - first_row - 1;
    const PageExtent extent = extent_of(static_cast<int>(broken.size()), rows, scroll);
    for (int row = 0; row < rows; ++row) {
        const auto line = static_cast<std::size_t>(row + extent.scroll);
        if (line < broken.size()) canvas.write(1, first_row + row, broken[line]);
    }
    draw_footer(canvas, footer, extent, look);
    return extent;
}

}  // namespace carom
