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
    const std::string_view where = extent.scroll == 0            ? " more below "
                                   : extent.scroll < extent.most ? " more "
                                                                 : " end ";
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

// Sections in as many columns as fit, with heights as even as whole sections allow.
std::vector<std::vector<Line>> columns_of_sections(std::span<const HelpSection> sections, int keys,
                                                   int count, int width, const Look& look) {
    std::vector<std::vector<Line>> parts;
    std::size_t total = 0;
    for (const HelpSection& section : sections) {
        parts.push_back(lines_of(section, keys, width, look));
        total += parts.back().size();
    }
    std::vector<std::vector<Line>> columns(1);
    const std::size_t each = total / static_cast<std::size_t>(count);
    for (std::vector<Line>& part : parts) {
        std::vector<Line>& last = columns.back();
        const bool is_full = !last.empty() && last.size() + part.size() / 2 > each;
        if (is_full && columns.size() < static_cast<std::size_t>(count)) columns.emplace_back();
        std::move(part.begin(), part.end(), std::back_inserter(columns.back()));
    }
    return columns;
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
    constexpr int most_width = 60;
    constexpr int between = 3;
    const int room = canvas.columns() - 2;
    const int count = std::clamp((room + between) / (least_width + between), 1, 4);
    const int width = std::min(most_width, (room + between) / count - between);
    const auto columns = columns_of_sections(sections, key_width(sections), count, width, look);

    std::size_t longest = 0;
    for (const auto& column : columns)
        longest = std::max(longest, column.size());
    const int rows = canvas.rows() - 1;
    // The blank line that ends the longest column needs no room.
    const PageExtent extent = extent_of(static_cast<int>(longest) - 1, rows, scroll);
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
