#pragma once

#include <vector>

#include "terminal/canvas/palette.h"

/// Lines in ASCII, drawn with the characters that people draw lines with: `- _ . ' | / \ +`.
///
/// A line is divided along one axis, in cells: a flat one has a piece in each column, a steep one
/// in each row. A piece belongs to the one cell that holds its middle, so a line is one
/// character thick wherever it lies, and its characters change only where it crosses from one third
/// of a cell to the next. The pieces of a polyline add up within a cell.
namespace carom {

/// What lines leave in a cell.
struct CellLine {
    float length = 0.0F;  ///< sum over the pieces, in cells along their axes
    /// Sums of the cosine and sine of twice the angle, times length: lines have no sign. Angles are
    /// measured in cells, clockwise from the right.
    float cosine = 0.0F;
    float sine = 0.0F;
    float down = 0.0F;  ///< sum of the height of the middle below the cell's top, times length
    bool is_faint = false;
    Ink ink;
};

/// Whether enough of a line lies in the cell to be shown there.
bool is_shown(const CellLine& line);

/// The character of a shown line: `+` where lines cross, dots for a faint one.
char glyph_of(const CellLine& line);

/// The strokes of a window of cells.
class LineLayer {
  public:
    LineLayer() = default;
    LineLayer(int columns, int rows);

    /// A point: x in columns, y in rows, from the top left.
    struct Point {
        double x = 0.0;
        double y = 0.0;
    };
    /// Pre: finite.
    void draw(Point start, Point end, const Ink& ink, bool is_faint);
    /// Something else covers the cell. Pre: it lies within the window.
    void erase(int column, int row) { at(column, row) = {}; }
    const CellLine& line(int column, int row) const;

  private:
    CellLine& at(int column, int row);
    void add(Point middle, double length, Point along, const Ink& ink, bool is_faint);

    int columns_ = 0;
    int rows_ = 0;
    std::vector<CellLine> lines_;
};

}  // namespace carom
