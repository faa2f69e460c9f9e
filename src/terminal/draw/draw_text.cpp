#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "level/text/utf8.h"
#include "terminal/canvas/character_width.h"
#include "terminal/draw/draw_parts.h"

/// Writes over the shapes: counters, labels, and annotations.
namespace carom {

namespace {

// Numbers over neighbouring bins may be staggered over this many rows.
constexpr std::size_t most_stagger = 3;

bool is_within(const CellArea& area, int column, int row) {
    return column >= area.column && column < area.column + area.columns && row >= area.row &&
           row < area.row + area.rows;
}

// A cell of the canvas; none where a point is outside the camera's area.
struct CellPlace {
    int column = 0;
    int row = 0;
};
std::optional<CellPlace> cell_of(const Camera& camera, Vec2 point) {
    const CellPoint place = to_cells(camera, point);
    const CellArea& area = camera.area;
    const bool is_seen = place.column >= area.column && place.column < area.column + area.columns &&
                         place.row >= area.row && place.row < area.row + area.rows;
    if (!is_seen) return std::nullopt;
    return CellPlace{static_cast<int>(std::floor(place.column)),
                     static_cast<int>(std::floor(place.row))};
}

void write_within(Canvas& canvas, const CellArea& area, CellPlace at, std::string_view text,
                  const Ink& ink) {
    for (int column = at.column; !text.empty(); ++column) {
        const std::size_t bytes = decode_utf8(text).bytes;
        if (is_within(area, column, at.row)) {
            canvas.write(column, at.row, text.substr(0, bytes), ink.color, default_color,
                         ink.attributes);
        }
        text.remove_prefix(bytes);
    }
}

// Text on a ball. On blocks of colour, the ball's colour is the background of the text.
void write_on_ball(Canvas& canvas, const CellArea& area, CellPlace at, std::string_view text,
                   const Ink& ink, const Look& look) {
    for (int column = at.column; !text.empty(); ++column) {
        const std::size_t bytes = decode_utf8(text).bytes;
        const bool is_seen = is_within(area, column, at.row) && canvas.holds(column, at.row);
        const Cell below = is_seen ? canvas.at(column, at.row) : Cell{};
        write_within(canvas, area, {column, at.row}, text.substr(0, bytes), ink);
        text.remove_prefix(bytes);
        const bool is_block = below.glyph == U'█' || below.glyph == U'▀' || below.glyph == U'▄';
        if (!is_seen || !is_block) continue;
        Cell& cell = canvas.at(column, at.row);
        if (look.has_colors()) {
            cell.background = below.foreground;
            const Ink strong = strong_text_on(cell.background, look);
            cell.foreground = strong.color;
            if (strong.attributes == plain) cell.attributes &= static_cast<std::uint8_t>(~bold);
        } else {
            cell.attributes = reverse;
        }
    }
}

// A count in as few characters as possible: 999, 12k, 3M.
std::string short_count(std::uint64_t count) {
    if (count < 10000) return fmt::format("{}", count);
    if (count < 10000000) return fmt::format("{}k", count / 1000);
    return fmt::format("{}M", count / 1000000);
}

bool has_name(const View& view, std::size_t ball) {
    const std::uint32_t id = number(view.world.balls().id[ball]);
    const auto& names = view.scene.ball_names;
    return id < names.size() && !names[id].empty();
}

std::string label_of(const View& view, std::size_t ball) {
    const std::uint32_t id = number(view.world.balls().id[ball]);
    if (view.options.labels == Labels::automatic && has_name(view, ball))
        return view.scene.ball_names[id];
    return fmt::format("{}", id);
}

// Brackets on both sides of a ball, outside its rim.
void bracket(Canvas& canvas, const View& view, std::size_t ball) {
    const Ink ink = ink_of(Role::selected, view.options.look);
    const auto write_at = [&](double x, std::string_view bracket) {
        const Vec2 position = view.world.balls().position[ball];
        if (const auto at = cell_of(view.camera, {position.x + x, position.y})) {
            write_within(canvas, view.camera.area, *at, bracket, ink);
        }
    };
    const double apart = view.world.balls().radius[ball] + 1.0 / view.camera.columns_per_length;
    write_at(-apart, "[");
    write_at(apart, "]");
}

void write_at_point(Canvas& canvas, const View& view, Vec2 point, std::string_view text,
                    const Ink& ink) {
    if (const auto at = cell_of(view.camera, point)) {
        write_within(canvas, view.camera.area, *at, text, ink);
    }
}

}  // namespace

void write_coordinates(Canvas& canvas, const View& view) {
    if (!view.options.overlays[overlay_named("grid")]) return;
    const CellArea& area = view.camera.area;
    const double spacing = round_spacing(view.camera.columns_per_length);
    const Box visible = visible_box(view.camera);
    const Ink ink = ink_of(Role::faint, view.options.look);
    const int bottom = area.row + area.rows - 1;
    // Counted in lines: far from the origin, a sum of spacings would drift, or stand still.
    const auto each_line = [&](double low, double high, auto write) {
        const double first = std::ceil(low / spacing);
        const double lines = std::floor(high / spacing) - first;
        for (int i = 0; i <= lines && i < area.columns; ++i) {
            const double value = (first + i) * spacing + 0.0;  // no -0
            write(value, fmt::format("{:.6g}", value));
        }
    };
    each_line(visible.low.x, visible.high.x, [&](double x, const std::string& text) {
        const int column = static_cast<int>(std::floor(to_cells(view.camera, {x, 0.0}).column)) + 1;
        const bool fits = column + columns_of(text) <= area.column + area.columns;
        if (fits) write_within(canvas, area, {column, bottom}, text, ink);
    });
    each_line(visible.low.y, visible.high.y, [&](double y, const std::string& text) {
        const int row = static_cast<int>(std::floor(to_cells(view.camera, {0.0, y}).row));
        if (row < bottom) write_within(canvas, area, {area.column, row}, text, ink);
    });
}

namespace {

// The number over a bin.
struct Counter {
    int row = 0;
    int first = 0;  // column
    int width = 0;
    std::string text;  // empty for an empty bin, which keeps its place among its neighbours
};

std::vector<Counter> counters_of(const View& view) {
    std::vector<Counter> counters;
    const std::vector<std::uint64_t> counts = census(view.world);
    for (const Zone& zone : view.world.zones()) {
        if (zone.counter >= counts.size()) continue;
        const Box box = bounds(zone.shape);
        const auto at = cell_of(view.camera, {center(box).x, box.high.y});
        if (!at) continue;
        const std::uint64_t count = counts[zone.counter];
        Counter counter;
        counter.text = count > 0 ? short_count(count) : "";
        counter.width = static_cast<int>(counter.text.size());
        counter.row = std::max(view.camera.area.row, at->row - 1);
        counter.first = at->column - (counter.width - 1) / 2;
        counters.push_back(std::move(counter));
    }
    std::ranges::stable_sort(counters, {},
                             [](const Counter& it) { return std::pair(it.row, it.first); });
    return counters;
}

// Over how many rows the numbers must take turns so that none touches the next in its row.
std::size_t rows_to_take_turns(std::span<const Counter> counters) {
    for (std::size_t rows = 1; rows < most_stagger; ++rows) {
        bool fits = true;
        for (std::size_t i = 0; i + rows < counters.size(); ++i) {
            const Counter& next = counters[i + rows];
            fits &= next.text.empty() || counters[i].text.empty() ||
                    counters[i].first + counters[i].width < next.first;
        }
        if (fits) return rows;
    }
    return most_stagger;
}

}  // namespace

void write_counters(Canvas& canvas, const View& view) {
    if (view.world.zones().empty()) return;
    const Ink ink = ink_of(Role::counter, view.options.look);
    const CellArea& area = view.camera.area;
    const std::vector<Counter> counters = counters_of(view);
    for (std::size_t first = 0; first < counters.size();) {
        std::size_t last = first;
        while (last < counters.size() && counters[last].row == counters[first].row)
            ++last;
        const std::span row(&counters[first], last - first);
        const std::size_t rows = rows_to_take_turns(row);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const int up = static_cast<int>(i % rows);
            if (row[i].row - up >= area.row)
                write_within(canvas, area, {row[i].first, row[i].row - up}, row[i].text, ink);
        }
        first = last;
    }
}

void write_labels(Canvas& canvas, const View& view) {
    const Labels labels = view.options.labels;
    const bool is_wanted =
        labels == Labels::all || (labels == Labels::automatic && !view.options.look.has_colors());
    const bool is_cloud = !view.annotations.copies.empty();
    if (!is_wanted || (is_cloud && labels != Labels::all)) return;
    const Balls& balls = view.world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double radius = balls.radius[i] * view.camera.columns_per_length;
        // The room inside a ball is the chord of the row, in columns.
        const double half_row = 0.5 * view.camera.aspect;
        const double chord =
            radius > half_row ? 2.0 * std::sqrt(radius * radius - half_row * half_row) : 0.0;
        if (labels == Labels::automatic && chord < 2.0) continue;
        const auto at = cell_of(view.camera, balls.position[i]);
        if (!at) continue;
        // Unasked, only names are worth their room.
        if (labels == Labels::automatic && !has_name(view, i)) continue;
        std::string text = label_of(view, i);
        const int room = static_cast<int>(std::min(chord, 100.0)) - 1;
        if (columns_of(text) > room && labels == Labels::all)
            text = fmt::format("{}", number(balls.id[i]));
        // Characters inside a ball would run into the text.
        if (renderer_in_force(view.options).has_regions() && columns_of(text) + 2 <= room)
            text = " " + text + " ";
        const int width = columns_of(text);
        if (width > room && labels == Labels::automatic) continue;
        Ink ink = view.inks[i];
        ink.attributes |= bold;
        const int column = width <= room ? at->column - (width - 1) / 2
                                         : at->column + 1 + static_cast<int>(radius);
        write_on_ball(canvas, view.camera.area, {column, at->row}, text, ink, view.options.look);
    }
}

void write_annotations(Canvas& canvas, const View& view) {
    const Annotations& annotations = view.annotations;
    const Look& look = view.options.look;
    if (annotations.selected_ball) {
        if (const auto ball = index_of(view.world, *annotations.selected_ball)) {
            bracket(canvas, view, *ball);
        }
    }
    if (annotations.selected_capsule) {
        if (const auto edge = index_of(view.world, *annotations.selected_capsule)) {
            const Capsule& shape = view.world.capsules().shape[*edge];
            const Ink ink = ink_of(Role::selected, look);
            write_at_point(canvas, view, shape.start, "O", ink);
            write_at_point(canvas, view, shape.end, "O", ink);
        }
    }
    for (const Vec2 place : annotations.marks) {
        if (auto at = cell_of(view.camera, place)) {
            Ink ink = ink_of(Role::error, look);
            ink.attributes |= bold | reverse;
            --at->column;
            write_within(canvas, view.camera.area, *at, look.utf8 ? "›×‹" : ">X<", ink);
        }
    }
    if (annotations.cue) {
        // Beside the pulled cue, on the side away from the ball.
        const bool is_left = annotations.cue->hand.x < annotations.cue->ball.x;
        const int width = columns_of(annotations.cue->speed);
        if (auto at = cell_of(view.camera, annotations.cue->hand)) {
            const int last = view.camera.area.column + view.camera.area.columns - width;
            at->column = is_left ? at->column - width - 1 : at->column + 2;
            at->column = std::max(view.camera.area.column, std::min(at->column, last));
            write_within(canvas, view.camera.area, *at, annotations.cue->speed,
                         ink_of(Role::cue, look));
        }
    }
    if (annotations.cursor) {
        Ink ink = ink_of(Role::cursor, look);
        ink.attributes |= reverse;
        write_at_point(canvas, view, *annotations.cursor, "+", ink);
    }
}

}  // namespace carom
