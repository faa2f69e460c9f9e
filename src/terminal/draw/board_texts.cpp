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

bool BoardTexts::is_under(std::size_t ball, int column, int row) const {
    const Balls& balls = view_.world.balls();
    const CellPoint at = to_cells(view_.camera, balls.position[ball]);
    const double radius = balls.radius[ball] * view_.camera.columns_per_length;
    return std::abs(at.column - (column + 0.5)) < radius + 1.0 &&
           std::abs(at.row - (row + 0.5)) < radius / view_.camera.aspect + 1.0;
}

bool BoardTexts::is_under_ball(int column, int row) const {
    for (std::size_t i = 0; i < view_.world.balls().size(); ++i)
        if (is_under(i, column, row)) return true;
    return false;
}

bool BoardTexts::is_under_moving_ball(int column, int row) const {
    constexpr double least_speed = 0.5;  // radii a second: what is slower stays
    const Balls& balls = view_.world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (length(balls.velocity[i]) > least_speed * balls.radius[i] && is_under(i, column, row))
            return true;
    return false;
}

// The glow of a light comes and goes, so it does not count, nor does a ball on its way over a cell.
bool BoardTexts::is_in_glow(int column, int row) const {
    if (!view_.annotations.table) return false;
    return std::ranges::any_of(view_.annotations.table->lights, [&](const TableLight& light) {
        const double glow = light.is_lit ? halo_radius(view_, light) : 0.0;
        if (glow == 0.0) return false;
        const CellPoint at = to_cells(view_.camera, light.shape.start);
        const double aside = std::abs(at.column - (column + 0.5));
        const double away = std::abs(at.row - (row + 0.5)) * view_.camera.aspect;
        const double light_radius = light.shape.radius * view_.camera.columns_per_length;
        return std::max(aside, away) > light_radius && aside < glow + 1.0 && away < glow + 1.0;
    });
}

bool BoardTexts::is_bare(int column, int row) const {
    return view_.memory.ground.is_bare(canvas_, column, row) || is_under_moving_ball(column, row) ||
           is_in_glow(column, row);
}

BoardTexts::Under BoardTexts::under(Span cells) const {
    std::optional<Under> all;
    for (int i = cells.first; i < cells.end; ++i) {
        const Under here = !is_bare(i, cells.row)                           ? Under::part
                           : view_.memory.ground.is_off_board(i, cells.row) ? Under::outside
                                                                            : Under::ground;
        if (all && *all != here) return Under::mixed;
        all = here;
    }
    return all.value_or(Under::ground);
}

bool BoardTexts::covers_light(Span text) const {
    if (!view_.annotations.table) return false;
    return std::ranges::any_of(view_.annotations.table->lights, [&](const TableLight& light) {
        const CellPoint at = to_cells(view_.camera, light.shape.start);
        return !light.is_edge && std::floor(at.row) == text.row && at.column >= text.first &&
               at.column < text.end;
    });
}

bool BoardTexts::is_in_view(Span text) const {
    const CellArea& area = view_.camera.area;
    return text.row >= area.row && text.row < area.row + area.rows && text.first >= area.column &&
           text.end <= area.column + area.columns;
}

// The best place with so many columns between texts.
std::optional<BoardTexts::Span> BoardTexts::place_for(Span text, int columns) const {
    const auto is_free = [&](Span there) { return is_in_view(there) && is_apart(there, columns); };
    if (is_free(text) && under(text) == Under::outside) return text;
    std::optional<Span> place;
    for (const int aside : ways_aside) {
        const Span there{text.row, text.first + aside, text.end + aside};
        if (!is_free(there) || under(there) != Under::ground) continue;
        // A blank on both sides sets a text that has moved apart from shapes.
        const int margin = aside == 0 ? 0 : 1;
        if (under({there.row, there.first - margin, there.end + margin}) == Under::ground)
            return there;
        if (!place) place = there;
    }
    return place;
}

void BoardTexts::write(int column, int row, std::string_view text, const Ink& ink) {
    std::optional<Span> place;
    for (const int columns : columns_between)
        if (!place) place = place_for({row, column, column + columns_of(text)}, columns);
    if (!place) return;
    written_.push_back(*place);
    for (int at = place->first; !text.empty(); ++at) {
        const std::size_t bytes = decode_utf8(text).bytes;
        if (view_.memory.ground.is_bare(canvas_, at, row) || !is_under_ball(at, row))
            canvas_.write(at, row, text.substr(0, bytes), ink.color, default_color, ink.attributes);
        text.remove_prefix(bytes);
    }
}

}  // namespace carom
