#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "terminal/canvas/color.h"

/// A picture in character cells. All drawing goes into a canvas, which tests read without a
/// terminal; the screen then sends the cells that changed.
namespace carom {

enum Attribute : std::uint8_t { plain = 0, bold = 1, dim = 2, reverse = 4, underline = 8 };

struct Cell {
    char32_t glyph = U' ';  ///< one column wide, printable
    Color foreground = default_color;
    Color background = default_color;
    std::uint8_t attributes = plain;

    friend bool operator==(const Cell&, const Cell&) = default;
};

/// A rectangle of cells of a canvas.
struct CellArea {
    int column = 0;  ///< of the left edge
    int row = 0;     ///< of the top edge
    int columns = 0;
    int rows = 0;

    friend bool operator==(const CellArea&, const CellArea&) = default;
};

/// Columns count from the left, rows from the top, both from 0. Writes outside the canvas do
/// nothing.
class Canvas {
  public:
    Canvas() = default;
    Canvas(int columns, int rows);  ///< all blank; negative sizes count as 0

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool holds(int column, int row) const;

    /// Pre: holds(column, row).
    const Cell& at(int column, int row) const;
    Cell& at(int column, int row);

    void put(int column, int row, const Cell& cell);
    /// Writes UTF-8 text (one column a code point; control characters as '?'), cut at the right
    /// edge. Returns the column after it.
    int write(int column, int row, std::string_view text, Color foreground = default_color,
              Color background = default_color, std::uint8_t attributes = plain);
    void fill(const Cell& cell);
    /// Makes the cells of an area blank.
    void clear(const CellArea& area);

    /// The glyphs as UTF-8, without colours, each row ended by a newline and without trailing
    /// blanks: for tests and documents.
    std::string text() const;

  private:
    int columns_ = 0;
    int rows_ = 0;
    std::vector<Cell> cells_;
};

}  // namespace carom
