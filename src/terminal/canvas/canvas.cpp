#include "terminal/canvas/canvas.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "level/text/utf8.h"
#include "terminal/canvas/character_width.h"

namespace carom {

Canvas::Canvas(int columns, int rows)
    : columns_(std::max(0, columns)),
      rows_(std::max(0, rows)),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

bool Canvas::holds(int column, int row) const {
    return column >= 0 && column < columns_ && row >= 0 && row < rows_;
}

const Cell& Canvas::at(int column, int row) const {
    assert(holds(column, row));
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

Cell& Canvas::at(int column, int row) {
    return const_cast<Cell&>(std::as_const(*this).at(column, row));
}

void Canvas::put(int column, int row, const Cell& cell) {
    if (holds(column, row)) at(column, row) = cell;
}

int Canvas::write(int column, int row, std::string_view text, Color foreground, Color background,
                  std::uint8_t attributes) {
    while (!text.empty() && column < columns_) {
        const DecodedCharacter next = decode_utf8(text);
        text.remove_prefix(next.bytes);
        const bool is_shown = next.character != not_a_character && is_one_column(next.character);
        put(column, row, {is_shown ? next.character : U'?', foreground, background, attributes});
        ++column;
    }
    return column;
}

void Canvas::fill(const Cell& cell) {
    std::fill(cells_.begin(), cells_.end(), cell);
}

void Canvas::clear(const CellArea& area) {
    for (int row = area.row; row < area.row + area.rows; ++row)
        for (int column = area.column; column < area.column + area.columns; ++column)
            put(column, row, {});
}

std::string Canvas::text() const {
    std::string text;
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            append_utf8(text, at(column, row).glyph);
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text.push_back('\n');
    }
    return text;
}

}  // namespace carom
