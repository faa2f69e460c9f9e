#include "terminal/draw/board_texts.h"

#include <algorithm>
#include <cmath>

#include "level/text/utf8.h"
#include "terminal/canvas/character_width.h"

namespace carom {
namespace {

constexpr int columns_between[] = {2, 1};
constexpr int ways_aside[] = {0, 1, -1, 2, -2, 3, -3};

}  // namespace

bool BoardTexts::is_apart(Span text, int columns) const {
    return std::ranges::none_of(written_, [&](const Span& other) {
        return other.row == text.row && text.first < other.end + columns &&
               other.first < text.end + columns;
    });
}

bool BoardTexts::is_under_ball(int column, int row) const {
    const Balls& balls = view_.world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const CellPoint at = to_cells(view_.camera, balls.position[i]);
        const double radius = balls.radius[i] * view_.camera.columns_per_length;
        if (std::abs(at.column - (column + 0.5)) < radius + 1.0 &&
            std::abs(at.row - (row + 0.5)) < radius / view_.camera.aspect + 1.0)
            return true;
    }
    return false;
}

// A ball on its way over the cells does not count.
bool BoardTexts::is_bare_ground(Span cells) const {
    for (int i = cells.first; i < cells.end; ++i)
        if (!view_.memory.ground.is_bare(canvas_, i, cells.row) && !is_under_ball(i, cells.row))
            return false;
    return true;
}

bool BoardTexts::covers_light(Span text) const {
    if (!view_.annotations.table) return false;
    return std::ranges::any_of(view_.annotations.table->lights, [&](const TableLight& light) {
        const CellPoint at = to_cells(view_.camera, light.shape.start);
        return !light.is_edge && std::floor(at.row) == text.row && at.column >= text.first &&
               at.column < text.end;
    });
}

// The best place with so many columns between texts.
std::optional<BoardTexts::Span> BoardTexts::place_for(Span text, int columns) const {
    std::optional<Span> place;
    for (const int aside : ways_aside) {
        const Span there{text.row, text.first + aside, text.end + aside};
        if (!is_apart(there, columns)) continue;
        // A blank on both sides sets a text that has moved apart from shapes.
        const int margin = aside == 0 ? 0 : 1;
        if (is_bare_ground({there.row, there.first - margin, there.end + margin})) return there;
        if (!place && (aside == 0 || !covers_light(there))) place = there;
    }
    return place;
}

void BoardTexts::write(int column, int row, std::string_view text, const Ink& ink) {
    std::optional<Span> place;
    for (const int columns : columns_between)
        if (!place) place = place_for({row, column, column + columns_of(text)}, columns);
    if (!place) return;
    written_.push_back(*place);
    const CellArea& area = view_.camera.area;
    for (int at = place->first; !text.empty(); ++at) {
        const std::size_t bytes = decode_utf8(text).bytes;
        const bool is_seen = at >= area.column && at < area.column + area.columns &&
                             row >= area.row && row < area.row + area.rows;
        const bool is_free =
            is_seen && (view_.memory.ground.is_bare(canvas_, at, row) || !is_under_ball(at, row));
        if (is_free)
            canvas_.write(at, row, text.substr(0, bytes), ink.color, default_color, ink.attributes);
        text.remove_prefix(bytes);
    }
}

}  // namespace carom
