#include "terminal/panels/panel.h"

#include <algorithm>
#include <array>

#include "level/text/utf8.h"
#include "terminal/canvas/character_width.h"

namespace carom {

namespace {

constexpr int text_gap = 2;

// Lays out the texts: calls put(row, column, text) for each.
template <class Put>
int flow(std::span<const PanelText> texts, int columns, Put put) {
    int row = 0;
    int column = 0;
    for (const PanelText& text : texts) {
        const int width = columns_of(text.text);
        if (column > 0 && column + width > columns) {
            ++row;
            column = 0;
        }
        put(row, column, text);
        column += width + text_gap;
    }
    return row + 1;
}

}  // namespace

std::string_view cut_to(std::string_view text, int columns) {
    std::size_t end = 0;
    for (; columns > 0 && end < text.size(); --columns)
        end += decode_utf8(text.substr(end)).bytes;
    return text.substr(0, end);
}

std::string shortened(std::string_view text, int columns, const Look& look) {
    if (columns_of(text) <= columns) return std::string(text);
    const std::string_view ellipsis = look.utf8 ? "\u2026" : "...";
    const std::string_view whole = cut_to(text, columns - columns_of(ellipsis) + 1);
    const std::size_t blank = whole.rfind(' ');
    const std::size_t last =
        blank == whole.npos ? whole.npos : whole.substr(0, blank).find_last_not_of(" ,:;");
    if (last == whole.npos) return std::string(cut_to(text, columns));
    return std::string(whole.substr(0, last + 1)) + std::string(ellipsis);
}

void write_cut(Canvas& canvas, const CellArea& area, int row, std::string_view text,
               const Ink& ink) {
    if (row < 0 || row >= area.rows) return;
    canvas.write(area.column, area.row + row, cut_to(text, area.columns), ink.color, default_color,
                 ink.attributes);
}

int rows_for(std::span<const PanelText> texts, int columns) {
    return flow(texts, columns, [](int, int, const PanelText&) {});
}

void write_flowing(Canvas& canvas, const CellArea& area, std::span<const PanelText> texts) {
    flow(texts, area.columns, [&](int row, int column, const PanelText& text) {
        const CellArea rest{area.column + column, area.row, area.columns - column, area.rows};
        write_cut(canvas, rest, row, text.text, text.ink);
    });
}

CellArea draw_axes(Canvas& canvas, const CellArea& area, const AxisEnds& ends, const Look& look) {
    const Ink faint = ink_of(Role::faint, look);
    const int side = std::max(columns_of(ends.high), columns_of(ends.low)) + 1;
    const CellArea inside{area.column + side, area.row + 1, area.columns - side, area.rows - 2};
    write_cut(canvas, area, 1, ends.high, faint);
    write_cut(canvas, area, area.rows - 2, ends.low, faint);
    const CellArea axis{inside.column, area.row + area.rows - 1, inside.columns, 1};
    write_cut(canvas, axis, 0, ends.from, faint);
    const int end = axis.column + axis.columns - columns_of(ends.to);
    if (end > axis.column + columns_of(ends.from))
        canvas.write(end, axis.row, ends.to, faint.color, default_color, faint.attributes);
    return inside;
}

namespace {

// Whether the blank at `at` stands between a number and its unit, which stay together: "3 s".
bool is_before_unit(std::string_view text, std::size_t at) {
    constexpr std::array<std::string_view, 9> units{"s",  "ms", "m", "mm", "cm",
                                                    "kg", "g",  "%", "m/s"};
    if (at == 0 || text[at - 1] < '0' || text[at - 1] > '9') return false;
    const std::string_view rest = text.substr(at + 1);
    const std::string_view word = rest.substr(0, rest.find_first_of(" ,.;:)"));
    return std::ranges::count(units, word) > 0;
}

// The blank where a line of at most `bytes` may end; npos: nowhere. Pre: bytes < text.size().
std::size_t last_break(std::string_view text, std::size_t bytes) {
    for (std::size_t at = bytes + 1; at-- > 1;)
        if (text[at] == ' ' && !is_before_unit(text, at)) return at;
    return std::string_view::npos;
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, int columns) {
    std::vector<std::string> lines;
    const int width = std::max(1, columns);
    do {
        std::string_view line = cut_to(text, width);
        if (line.size() < text.size()) {
            const std::size_t blank = last_break(text, line.size());
            if (blank != std::string_view::npos) line = text.substr(0, blank);
        }
        text.remove_prefix(line.size());
        while (line.ends_with(' '))
            line.remove_suffix(1);
        lines.emplace_back(line);
        while (!text.empty() && text.front() == ' ')
            text.remove_prefix(1);
    } while (!text.empty());
    return lines;
}

}  // namespace carom
