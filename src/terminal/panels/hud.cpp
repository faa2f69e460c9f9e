#include "terminal/panels/hud.h"

#include <algorithm>
#include <string_view>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/hud_fields.h"
#include "terminal/panels/panel.h"

namespace carom {

namespace {

struct Bar {
    Canvas& canvas;
    const Look& look;
    int row = 0;
    Color ground = default_color;
    std::uint8_t attributes = plain;

    void clear() const {
        for (int column = 0; column < canvas.columns(); ++column) {
            canvas.put(column, row, {U' ', default_color, ground, attributes});
        }
    }
    int write(int column, std::string_view text, const Ink& ink) const {
        const auto all = static_cast<std::uint8_t>(ink.attributes | attributes);
        return canvas.write(column, row, text, ink.color, ground, all);
    }
    int write(int column, const HudField& field) const {
        if (!field.label.empty()) {
            column = write(column, field.label + " ", ink_of(Role::faint, look));
        }
        return write(column, field.value, field.ink);
    }
    int write(int column, const std::vector<HudField>& fields) const {
        for (const HudField& field : fields)
            column = write(column, field) + hud_field_gap;
        return column;
    }
};

// The first line is highlighted against the world above it.
Bar title_bar(Canvas& canvas, int row, const Look& look) {
    if (look.colors >= 256) {
        return {canvas, look, row, static_cast<Color>(look.light_background ? 254 : 236), plain};
    }
    return {canvas, look, row, default_color, look.has_colors() ? plain : reverse};
}

// The parts of a game's line that fit, whole; of the first, as much as fits.
std::string fitting_parts(std::string_view game, int columns, const Look& look) {
    while (columns_of(game) > columns) {
        const std::size_t last = game.rfind("  ");
        if (last == game.npos || last == 0) return shortened(game, columns, look);
        game = game.substr(0, last);
    }
    return std::string(game);
}

void draw_physics(const Bar& bar, const HudInfo& info) {
    bar.clear();
    const int columns = bar.canvas.columns() - 2;
    if (info.beside.empty() && (info.is_game || !info.game.empty())) {
        const bool has_line = !info.game.empty();
        bar.write(1, fitting_parts(has_line ? info.game : info.goal, columns, bar.look),
                  ink_of(has_line ? Role::text : Role::warning, bar.look));
        return;
    }
    bar.write(1, physics_fields(info, columns, bar.look));
}

// The title gets the room that the fields leave.
void draw_first(const Bar& bar, const HudInfo& info, std::vector<HudField> fields) {
    bar.clear();
    const int columns = bar.canvas.columns();
    // Half of the line is for the title, if it is that long; in a narrow window, the least that it
    // needs.
    const auto state = std::ranges::find(fields, 0, &HudField::rank);
    const int first = state == fields.end() ? 0 : width_of(*state) + hud_field_gap;
    const int others = info.title_comes_first ? first + 2 : columns / 2 + 8;
    const int least_title = info.title_comes_first || columns >= 60
                                ? std::max(0, std::min(columns_of(info.title), columns - others))
                                : 0;
    fields = fitting_fields(std::move(fields),
                            columns - 2 - (least_title > 0 ? least_title + hud_field_gap : 0));
    int room = columns - 2 - width_of(fields) - hud_field_gap;
    int column = 1;
    for (const std::string* const name : {&info.name, &info.short_name}) {
        const int width = columns_of(*name) + hud_field_gap;
        if (name->empty() || width + columns_of(info.title) > room) continue;
        column = bar.write(column, *name, ink_of(Role::text, bar.look)) + hud_field_gap;
        room -= width;
        break;
    }
    if (room >= 4 && !info.title.empty()) {
        const std::string title = shortened(info.title, room, bar.look);
        column = bar.write(column, title, ink_of(Role::strong, bar.look)) + hud_field_gap;
    }
    bar.write(column, fields);
}

int width_of_hint(const KeyHelp& hint) {
    return columns_of(hint.keys) + 1 + columns_of(hint.what);
}

// The text that takes the place of the hints in a short window, which has no other line for it.
std::string instead_of_hints(const Canvas& canvas, const HudInfo& info) {
    if (hud_rows(canvas.columns(), canvas.rows()) != 2) return "";
    return info.beside.empty() ? info.game : info.beside;
}

bool has_line_for_choices(const Canvas& canvas, const HudInfo& info) {
    int width = 0;
    for (const KeyHelp& choice : info.choices)
        width += width_of_hint(choice) + hud_field_gap;
    for (const KeyHelp& hint : info.hints)
        if (hint.stays) width += width_of_hint(hint) + hud_field_gap;
    return hud_rows(canvas.columns(), canvas.rows()) >= 2 &&
           instead_of_hints(canvas, info).empty() && width - hud_field_gap <= canvas.columns() - 2;
}

void draw_hints(const Bar& bar, const HudInfo& info) {
    bar.clear();
    if (const std::string other = instead_of_hints(bar.canvas, info); !other.empty()) {
        bar.write(1, fitting_parts(other, bar.canvas.columns() - 2, bar.look),
                  ink_of(Role::warning, bar.look));
        return;
    }
    std::vector<KeyHelp> hints;
    if (has_line_for_choices(bar.canvas, info)) hints = info.choices;
    hints.insert(hints.end(), info.hints.begin(), info.hints.end());
    int reserved = 0;
    for (const KeyHelp& hint : hints)
        if (hint.stays) reserved += width_of_hint(hint) + hud_field_gap;
    int column = 1;
    bool is_full = false;
    for (const KeyHelp& hint : hints) {
        const int width = width_of_hint(hint);
        if (hint.stays) reserved -= width + hud_field_gap;
        const int needed = hint.stays ? width : width + reserved;
        is_full = is_full || column + needed > bar.canvas.columns() - 1;
        if (is_full && (!hint.stays || column + width > bar.canvas.columns() - 1)) continue;
        column = bar.write(column, hint.keys, ink_of(Role::strong, bar.look)) + 1;
        column = bar.write(column, hint.what, ink_of(Role::faint, bar.look)) + hud_field_gap;
    }
}

// A sentence is wrapped; several lines, such as errors with carets, stay as they are.
std::vector<std::string> message_lines(const std::string& message, int columns) {
    if (message.find('\n') == std::string::npos) return wrapped(message, columns);
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < message.size();) {
        const std::size_t end = std::min(message.find('\n', from), message.size());
        lines.emplace_back(cut_to(std::string_view(message).substr(from, end - from), columns));
        from = end + 1;
    }
    return lines;
}

Ink message_ink(const HudInfo& info, const Look& look) {
    return ink_of(info.message_is_error ? Role::error : Role::warning, look);
}

bool shows_message_in_line(const HudInfo& info, int columns, int rows) {
    return info.message_in_line && rows >= 2 && !info.message.empty() &&
           info.message.find('\n') == std::string::npos && columns_of(info.message) <= columns - 2;
}

// The lines of the message, at most half of the rows of the world; then the choices that have no
// other line.
std::vector<std::string> lines_over_world(const Canvas& canvas, int below, const HudInfo& info) {
    const int columns = canvas.columns() - 2;
    std::vector<std::string> lines;
    if (!info.message.empty() &&
        !shows_message_in_line(info, canvas.columns(), hud_rows(canvas.columns(), canvas.rows())))
        lines = message_lines(info.message, columns);
    const auto room = static_cast<std::size_t>((below + 1) / 2);
    if (lines.size() > room) {
        lines.resize(room);
        if (!info.message_more.empty()) lines.back() = info.message_more;
    }
    if (has_line_for_choices(canvas, info)) return lines;
    for (const KeyHelp& choice : info.choices)
        for (std::string& line : wrapped(choice.keys + " " + choice.what, columns))
            lines.push_back(std::move(line));
    if (lines.size() > static_cast<std::size_t>(below))
        lines.erase(lines.begin(), lines.end() - below);
    return lines;
}

// Over the last rows of the world, and as wide as the text is.
void draw_over_world(Canvas& canvas, int below, const HudInfo& info, const Look& look) {
    if (below <= 0) return;
    const std::vector<std::string> lines = lines_over_world(canvas, below, info);
    if (lines.empty()) return;
    int width = 0;
    for (const std::string& line : lines)
        width = std::max(width, columns_of(line));
    const Ink ink = message_ink(info, look);
    int row = below - static_cast<int>(lines.size());
    for (const std::string& line : lines)
        title_bar(canvas, row++, look).write(0, " " + padded(line, width) + " ", ink);
}

}  // namespace

int hud_rows(int columns, int rows) {
    if (rows < 10 || columns < 24) return std::min(1, std::max(rows, 0));
    return rows < 16 ? 2 : 3;
}

CellArea world_area(int columns, int rows) {
    return {0, 0, std::max(0, columns), std::max(0, rows - hud_rows(columns, rows))};
}

void draw_hud(Canvas& canvas, const HudInfo& info, const Look& look) {
    const int count = hud_rows(canvas.columns(), canvas.rows());
    const int first = canvas.rows() - count;
    const Bar top = title_bar(canvas, first, look);
    std::vector<HudField> play = play_fields(info, look);
    const bool is_in_line = shows_message_in_line(info, canvas.columns(), count);
    draw_over_world(canvas, first, info, look);
    if (count == 0) return;
    draw_first(top, info, std::move(play));
    if (count == 1) return;
    if (count == 3) draw_physics({canvas, look, first + 1}, info);
    draw_hints({canvas, look, first + count - 1}, info);
    if (!is_in_line) return;
    const Bar line{canvas, look, first + 1};
    line.clear();
    line.write(1, info.message, message_ink(info, look));
}

}  // namespace carom
