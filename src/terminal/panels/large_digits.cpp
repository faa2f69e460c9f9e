#include "terminal/panels/large_digits.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace carom {
namespace {

constexpr int glyph_rows = 5;

// Five rows of three dots each, from the top, the leftmost dot in the highest bit.
struct Glyph {
    char character = ' ';
    int columns = 3;
    std::array<std::uint8_t, glyph_rows> rows{};
};
constexpr std::array<Glyph, 11> glyphs = {{{'0', 3, {7, 5, 5, 5, 7}},
                                           {'1', 3, {2, 6, 2, 2, 7}},
                                           {'2', 3, {7, 1, 7, 4, 7}},
                                           {'3', 3, {7, 1, 3, 1, 7}},
                                           {'4', 3, {5, 5, 7, 1, 1}},
                                           {'5', 3, {7, 4, 7, 1, 7}},
                                           {'6', 3, {7, 4, 7, 5, 7}},
                                           {'7', 3, {7, 1, 1, 2, 2}},
                                           {'8', 3, {7, 5, 7, 5, 7}},
                                           {'9', 3, {7, 5, 7, 1, 7}},
                                           {',', 2, {0, 0, 0, 2, 4}}}};

const Glyph* glyph_of(char character) {
    const auto* found = std::ranges::find(glyphs, character, &Glyph::character);
    return found == glyphs.end() ? nullptr : found;
}

bool is_dot(const Glyph& glyph, int row, int column) {
    return row < glyph_rows && (glyph.rows[static_cast<std::size_t>(row)] >> (2 - column) & 1) != 0;
}

// The dots of a cell: one in ASCII, an upper and a lower one with half blocks.
char32_t cell_of(const Glyph& glyph, int row, int column, int scale, const Look& look) {
    if (!look.utf8) return is_dot(glyph, row / scale, column / scale) ? U'#' : U' ';
    const bool upper = is_dot(glyph, 2 * row / scale, column / scale);
    const bool lower = is_dot(glyph, (2 * row + 1) / scale, column / scale);
    return upper && lower ? U'█' : upper ? U'▀' : lower ? U'▄' : U' ';
}

}  // namespace

int large_width(std::string_view text) {
    int width = -1;
    for (const char character : text) {
        const Glyph* glyph = glyph_of(character);
        width += (glyph ? glyph->columns : 3) + 1;
    }
    return std::max(width, 0);
}

int large_rows(const Look& look) {
    return look.utf8 ? (glyph_rows + 1) / 2 : glyph_rows;
}

void write_large(Canvas& canvas, int column, int row, std::string_view text, int scale,
                 const Ink& ink, const Look& look) {
    for (const char character : text) {
        const Glyph* glyph = glyph_of(character);
        if (!glyph) continue;
        for (int down = 0; down < scale * large_rows(look); ++down)
            for (int across = 0; across < scale * glyph->columns; ++across)
                canvas.put(column + across, row + down,
                           {cell_of(*glyph, down, across, scale, look), ink.color, default_color,
                            ink.attributes});
        column += scale * (glyph->columns + 1);
    }
}

void draw_large_count(Canvas& canvas, const CellArea& area, std::string_view count,
                      const Look& look) {
    constexpr int margin = 2;
    constexpr int roomy = 30;  // rows
    const int scale = area.rows >= roomy ? 2 : 1;
    const int width = scale * large_width(count);
    if (area.rows < 2 * large_rows(look) || area.columns < 2 * (width + margin)) return;
    write_large(canvas, area.column + area.columns - width - margin, area.row + margin / 2, count,
                scale, ink_of(Role::counter, look), look);
}

}  // namespace carom
