#include "terminal/panels/split.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/panel.h"

namespace carom {
namespace {

/// Stacked halves are harder to compare, so they must show this much larger to be preferred.
constexpr double worth_stacking = 1.25;

struct Half {
    CellArea title;
    CellArea picture;
};

Half half_of(const CellArea& area) {
    return {{area.column, area.row, area.columns, std::min(1, area.rows)},
            {area.column, area.row + 1, area.columns, std::max(0, area.rows - 1)}};
}

Split side_by_side(const CellArea& area) {
    const int columns = std::max(0, (area.columns - 1) / 2);
    const Half left = half_of({area.column, area.row, columns, area.rows});
    const int middle = area.column + columns;
    // Of an even number of columns the spare one lies beside the divider, not at the edge.
    const Half right =
        half_of({area.column + area.columns - columns, area.row, columns, area.rows});
    return {left.title,
            left.picture,
            right.title,
            right.picture,
            {middle, area.row, std::min(1, area.columns), area.rows}};
}

Split stacked(const CellArea& area) {
    const int rows = area.rows / 2;
    const Half upper = half_of({area.column, area.row, area.columns, rows});
    const Half lower = half_of({area.column, area.row + rows, area.columns, rows});
    return {upper.title, upper.picture, lower.title, lower.picture, {}};
}

void draw_title(Canvas& canvas, const CellArea& area, const HalfTitle& title, const Look& look) {
    if (area.rows == 0) return;
    const Color ground = look.colors >= 256 ? (look.light_background ? 254 : 236) : default_color;
    const std::uint8_t bar = look.has_colors() ? plain : reverse;
    for (int column = 0; column < area.columns; ++column)
        canvas.put(area.column + column, area.row, {U' ', default_color, ground, bar});
    const Ink strong = ink_of(Role::strong, look);
    const Ink text = ink_of(Role::text, look);
    const int end = area.column + area.columns;
    const auto write = [&](int column, std::string_view what, const Ink& ink) {
        const auto attributes = static_cast<std::uint8_t>(ink.attributes | bar);
        return canvas.write(column, area.row, cut_to(what, end - column), ink.color, ground,
                            attributes);
    };
    int column = write(area.column + 1, title.solver, strong) + 2;
    const std::array facts = {fmt::format("tick {:<6}", title.tick),
                              fmt::format("{} collisions", title.collisions)};
    for (const std::string& fact : facts)
        if (column + columns_of(fact) <= end) column = write(column, fact, text) + 2;
}

}  // namespace

Split split(const CellArea& area, const Box& view, double aspect) {
    const Split beside = side_by_side(area);
    const Split above = stacked(area);
    const auto scale = [&](const Split& halves) {
        return fit_camera(view, halves.first, aspect).columns_per_length;
    };
    return scale(above) > worth_stacking * scale(beside) ? above : beside;
}

void draw_split(Canvas& canvas, const Split& split, const HalfTitle& first, const HalfTitle& second,
                const Look& look) {
    draw_title(canvas, split.first_title, first, look);
    draw_title(canvas, split.second_title, second, look);
    const Ink faint = ink_of(Role::faint, look);
    for (int row = 0; row < split.divider.rows; ++row)
        for (int column = 0; column < split.divider.columns; ++column)
            canvas.put(split.divider.column + column, split.divider.row + row,
                       {look.utf8 ? U'│' : U'|', faint.color, default_color, faint.attributes});
}

}  // namespace carom
