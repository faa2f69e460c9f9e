#include "terminal/canvas/cell_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {

namespace {

constexpr float least_shown = 0.3F;
// Below this share of common direction, lines cross.
constexpr float least_common = 0.4F;
constexpr double least_slash = 0.65;  // rows a column: the flattest line that is drawn with slashes

// Flat lines, by the height of their middle below the cell's top.
char flat_glyph(double slope, double down) {
    constexpr double level = 0.1;  // rows a column
    if (std::abs(slope) < level) return down < 0.75 ? '-' : '_';
    if (down < 0.3) return slope > 0.0 ? '`' : '\'';
    if (down < 0.62) return '-';
    return down < 0.8 || std::abs(slope) > 0.3 ? '.' : '_';
}

}  // namespace

bool is_shown(const CellLine& line) {
    return line.length >= least_shown;
}

char glyph_of(const CellLine& line) {
    const double angle = 0.5 * std::atan2(line.sine, line.cosine);  // -90 to 90 degrees
    const double slope = std::tan(angle);
    constexpr double upright = 3.2;  // rows a column: the steepest slash
    if (line.is_faint) return std::abs(slope) < 1.0 ? '.' : ':';
    if (std::hypot(line.cosine, line.sine) < least_common * line.length) return '+';
    if (std::abs(slope) > upright) return '|';
    if (std::abs(slope) >= least_slash) return slope > 0.0 ? '\\' : '/';
    return flat_glyph(slope, line.down / line.length);
}

LineLayer::LineLayer(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      lines_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

CellLine& LineLayer::at(int column, int row) {
    return lines_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

const CellLine& LineLayer::line(int column, int row) const {
    return lines_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

void LineLayer::add(Point middle, double length, Point along, const Ink& ink, bool is_faint) {
    if (!(middle.x >= 0.0 && middle.x < columns_ && middle.y >= 0.0 && middle.y < rows_)) return;
    CellLine& line = at(static_cast<int>(middle.x), static_cast<int>(middle.y));
    // A line in another ink, or a stronger one, replaces what is there, but crossings remain.
    if (line.is_faint && !is_faint) line = {};
    const double squared = along.x * along.x + along.y * along.y;
    line.length += static_cast<float>(length);
    line.cosine += static_cast<float>(length * (along.x * along.x - along.y * along.y) / squared);
    line.sine += static_cast<float>(length * 2.0 * along.x * along.y / squared);
    line.down += static_cast<float>(length * (middle.y - std::floor(middle.y)));
    line.is_faint = is_faint;
    line.ink = ink;
}

void LineLayer::draw(Point start, Point end, const Ink& ink, bool is_faint) {
    // One slash in each row, also where the line is a little flatter than a slash.
    const bool is_flat = least_slash * std::abs(end.x - start.x) >= std::abs(end.y - start.y);
    const auto along = [&](Point p) { return is_flat ? p.x : p.y; };
    if (along(start) > along(end)) std::swap(start, end);
    const double extent = along(end) - along(start);
    const double most = is_flat ? columns_ : rows_;
    if (!(extent > 0.0) || !(along(start) < most && along(end) > 0.0)) return;
    const Point direction{(end.x - start.x) / extent, (end.y - start.y) / extent};
    const int first = static_cast<int>(std::max(0.0, std::floor(along(start))));
    const int last = static_cast<int>(std::min(most - 1.0, std::floor(along(end))));
    for (int i = first; i <= last; ++i) {
        const double from = std::max<double>(i, along(start));
        const double to = std::min<double>(i + 1.0, along(end));
        if (!(to > from)) continue;
        const double way = 0.5 * (from + to) - along(start);
        add({start.x + way * direction.x, start.y + way * direction.y}, to - from, direction, ink,
            is_faint);
    }
}

}  // namespace carom
