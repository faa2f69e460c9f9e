#include "terminal/screen/screen_cells.h"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <wchar.h>

#include <algorithm>
#include <cstddef>

#include "terminal/input/capabilities.h"

namespace carom {
namespace {

constexpr int palette = 256;
// A gap of unchanged cells shorter than this joins two spans: ncurses compares anyway.
constexpr int short_gap = 8;

bool is_blank(const Cell& cell) {
    return cell.glyph == U' ' && cell.background == default_color &&
           (cell.attributes & (reverse | underline)) == 0;
}

bool looks_like(const Cell& a, const Cell& b) {
    return a == b || (is_blank(a) && is_blank(b));
}

unsigned attributes_of(std::uint8_t attributes) {
    unsigned result = A_NORMAL;
    if ((attributes & bold) != 0) result |= A_BOLD;
    if ((attributes & dim) != 0) result |= A_DIM;
    if ((attributes & reverse) != 0) result |= A_REVERSE;
    if ((attributes & underline) != 0) result |= A_UNDERLINE;
    return result;
}

// Without colours, a bright background behind dark text is told by reversing the cell.
bool is_reversed(const Cell& cell) {
    if (cell.background == default_color) return false;
    constexpr double own_ink = 0.9;  // of a dark terminal
    const double ink = cell.foreground < 0 ? own_ink : luminance(rgb_of(cell.foreground));
    return luminance(rgb_of(cell.background)) > ink;
}

// A full block on a ground of its own colour is that ground: one byte, and no ink that spills over
// the border of the cell and stays there, as the blocks of many fonts do.
bool is_all_ground(const Cell& cell, int colors) {
    return colors > 0 && cell.glyph == U'█' && cell.background != default_color &&
           cell.background == cell.foreground && (cell.attributes & reverse) == 0;
}

wchar_t character_of(char32_t glyph, bool utf8) {
    const auto character = static_cast<wchar_t>(glyph);
    const bool is_ascii = glyph >= U' ' && glyph < 0x7f;
    return is_ascii || (utf8 && wcwidth(character) == 1) ? character : L'?';
}

}  // namespace

ColorPairs::ColorPairs() : pairs_(static_cast<std::size_t>((palette + 1) * (palette + 1)), 0) {}

int& ColorPairs::slot(int foreground, int background) {
    return pairs_[static_cast<std::size_t>((foreground + 1) * (palette + 1) + background + 1)];
}

int ColorPairs::number(Color foreground, Color background, int colors) {
    // Colours that look the same on this terminal share their pairs.
    const auto place = [&](Color color) {
        return colors > palette ? int{color} : color_for_terminal(color, colors);
    };
    int& pair = slot(place(foreground), place(background));
    if (pair != 0 || (foreground < 0 && background < 0)) return pair;
    constexpr int most_pairs = 32767;
    if (next_ >= std::min(COLOR_PAIRS, most_pairs) ||
        init_extended_pair(next_, color_for_terminal(foreground, colors),
                           color_for_terminal(background, colors)) == ERR) {
        return slot(place(foreground), default_color);
    }
    pair = next_++;
    return pair;
}

bool CursesCells::has_shape_of(const Canvas& canvas) const {
    return canvas.columns() == shown_.columns() && canvas.rows() == shown_.rows();
}

void CursesCells::forget(const Canvas& canvas) {
    shown_ = Canvas(canvas.columns(), canvas.rows());
}

void CursesCells::put(const Canvas& canvas, int colors, bool utf8) {
    const int columns = std::min(canvas.columns(), COLS);
    for (int row = 0; row < std::min(canvas.rows(), LINES); ++row) {
        int first = -1;  // of the span that is being gathered; -1: none
        int end = 0;
        for (int column = 0; column < columns; ++column) {
            if (looks_like(canvas.at(column, row), shown_.at(column, row))) continue;
            if (first >= 0 && column - end >= short_gap) {
                put_span(canvas, row, first, end, colors, utf8);
                first = -1;
            }
            if (first < 0) first = column;
            end = column + 1;
        }
        if (first >= 0) put_span(canvas, row, first, end, colors, utf8);
    }
    shown_ = canvas;
}

void CursesCells::put_span(const Canvas& canvas, int row, int first, int end, int colors,
                           bool utf8) {
    std::vector<cchar_t> span;
    for (int column = first; column < end; ++column) {
        const Cell& cell = canvas.at(column, row);
        unsigned attributes = A_NORMAL;
        int pair = 0;
        if (!is_blank(cell)) {  // blanks look the same in whatever colour
            attributes = attributes_of(cell.attributes);
            if (colors > 0) pair = pairs_.number(cell.foreground, cell.background, colors);
            if (colors == 0 && is_reversed(cell)) attributes ^= A_REVERSE;
        }
        const char32_t glyph = is_all_ground(cell, colors) ? U' ' : cell.glyph;
        const wchar_t text[2] = {character_of(glyph, utf8), L'\0'};
        setcchar(&span.emplace_back(), text, attributes, static_cast<short>(pair), &pair);
    }
    mvwadd_wchnstr(stdscr, row, first, span.data(), end - first);
}

}  // namespace carom
