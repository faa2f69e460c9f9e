#include "terminal/panels/hud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/panel.h"

namespace carom {

namespace {

// One item of a status line. Numbers keep their width while they change, so that the items behind
// them do not move.
struct Field {
    std::string label;
    std::string value;
    Ink ink;
    int rank = 0;  ///< the field of rank 0 is dropped last
};

constexpr int gap = 2;

int width_of(const Field& field) {
    const int label = columns_of(field.label);
    return label + (label > 0 ? 1 : 0) + columns_of(field.value);
}

int width_of(const std::vector<Field>& fields) {
    int width = -gap;
    for (const Field& field : fields)
        width += width_of(field) + gap;
    return width;
}

// The fields that fit into `columns`, in their order; the least important are dropped first.
std::vector<Field> fitting_fields(std::vector<Field> fields, int columns) {
    while (!fields.empty() && width_of(fields) > columns) {
        fields.erase(
            std::max_element(fields.begin(), fields.end(),
                             [](const Field& a, const Field& b) { return a.rank < b.rank; }));
    }
    return fields;
}

std::string padded(std::string text, int width) {
    const int missing = width - columns_of(text);
    if (missing > 0) text.append(static_cast<std::size_t>(missing), ' ');
    return text;
}

// Five digits, whatever the magnitude.
std::string quantity(double value) {
    return fmt::format("{:<10.5g}", value);
}

// A component that is only rounding of the other is shown as 0.
std::string momentum(Vec2 p) {
    const double noise = 1e-9 * std::max(std::abs(p.x), std::abs(p.y));
    const auto component = [&](double value) { return std::abs(value) < noise ? 0.0 : value; };
    return fmt::format("{:<+9.3g} {:<+9.3g}", component(p.x), component(p.y));
}

std::string duration(double seconds) {
    if (std::abs(seconds) < 1e5) return fmt::format("{:>9.3f} s", seconds);
    return fmt::format("{:>9.5g} s", seconds);
}

std::string factor(double speed) {
    return fmt::format("x{:<5.3g}", speed);
}

Field drift_field(std::string_view label, double drift, int rank, const Look& look) {
    const double size = std::abs(drift);
    const Role role = size < 1e-9 ? Role::good : size < 1e-3 ? Role::text : Role::warning;
    std::string text = drift == 0.0 ? "0" : fmt::format("{:+.1e}", drift);
    return {std::string(label), padded(std::move(text), 8), ink_of(role, look), rank};
}

// "2817 of 3141", "5.9871 of 6", "0.4 < 0.5": green once the value is as expected.
Field check_field(const HudCheck& check, int rank, const Look& look) {
    const std::string value = fmt::format("{:.8g}", check.value);
    const std::string measured = check.is_exact ? fmt::format("{:.8g}", check.measured)
                                                : fmt::format("{:.5g}", check.measured);
    const int width = check.is_exact ? columns_of(value) : std::max(7, columns_of(value));
    return {check.quantity, fmt::format("{:>{}} {} {}", measured, width, check.relation, value),
            ink_of(check.holds ? Role::good : Role::text, look), rank};
}

// The state of play: running or paused, how fast, and how far back.
Field state_field(const HudInfo& info, const Look& look) {
    if (info.is_paused) {
        const std::string_view sign = look.utf8 ? "‖ " : "|| ";
        return {"", fmt::format("{}paused", sign), ink_of(Role::warning, look), 0};
    }
    const std::string_view sign = look.utf8 ? "▸ " : "> ";
    return {"", fmt::format("{}{:<6}", sign, factor(info.speed)), ink_of(Role::good, look), 0};
}

// Of a game: whether it runs, what is unusual about it, and its goal, where the second line has
// other things to say.
std::vector<Field> game_fields(const HudInfo& info, const Look& look) {
    std::vector<Field> fields;
    if (!info.game.empty() && !info.goal.empty() && !info.title_comes_first)
        fields.push_back({"", info.goal, ink_of(Role::warning, look), 4});
    if (info.is_paused || info.speed != 1.0) fields.push_back(state_field(info, look));
    if (info.latest_tick > info.tick)
        fields.push_back({"", duration(info.time), ink_of(Role::text, look), 1});
    if (!info.mode.empty()) fields.push_back({"", info.mode, ink_of(Role::warning, look), 2});
    return fields;
}

std::vector<Field> play_fields(const HudInfo& info, const Look& look) {
    if (info.is_game) return game_fields(info, look);
    const Ink text = ink_of(Role::text, look);
    std::vector<Field> fields;
    fields.push_back(state_field(info, look));
    fields.push_back({"", duration(info.time), text, 1});
    std::string tick = fmt::format("{}", info.tick);
    if (info.latest_tick > info.tick) tick += fmt::format("/{}", info.latest_tick);
    fields.push_back({"tick", padded(std::move(tick), 7), text, 5});
    fields.push_back({"", info.solver + (info.solver_is_picked ? " (auto)" : ""),
                      ink_of(Role::strong, look), 2});
    if (info.solver_is_picked && !info.reason.empty())
        fields.push_back({"", info.reason, ink_of(Role::faint, look), 9});
    const bool is_late = !info.is_paused && info.ticks_per_second < 0.9 * info.rate * info.speed;
    fields.push_back({"", fmt::format("{:>5.0f}/{:.0f} ticks/s", info.ticks_per_second, info.rate),
                      is_late ? ink_of(Role::warning, look) : text, 3});
    fields.push_back({"balls", fmt::format("{:<5}", info.balls), text, 4});
    if (info.clustered > 0)
        fields.push_back({"", fmt::format("{} of {} under contact", info.clustered, info.balls),
                          ink_of(Role::warning, look), 3});
    if (!info.mode.empty()) fields.push_back({"", info.mode, text, 6});
    return fields;
}

std::vector<Field> physics_fields(const HudInfo& info, const Look& look) {
    const Ink text = ink_of(Role::text, look);
    std::vector<Field> fields;
    if (!info.beside.empty()) fields.push_back({"", info.beside, ink_of(Role::warning, look), -1});
    if (info.beside.empty() && !info.goal.empty())
        fields.push_back({"", info.goal, ink_of(Role::warning, look), -1});
    int rank = 1;
    bool has_collisions = false;
    for (const HudCheck& check : info.checks) {
        fields.push_back(check_field(check, rank, look));
        rank = 8;
        has_collisions = has_collisions || check.quantity == "collisions";
    }
    if (!has_collisions) {
        fields.push_back({"collisions", fmt::format("{:<8}", info.collisions), text, 5});
    }
    fields.push_back({"KE", quantity(info.kinetic_energy), text, 0});
    if (info.potential_energy) {
        fields.push_back({"PE", quantity(*info.potential_energy), text, 6});
    }
    if (info.energy_drift) fields.push_back(drift_field("drift", *info.energy_drift, 2, look));
    fields.push_back({"p", momentum(info.momentum), text, 4});
    if (info.momentum_drift) fields.push_back(drift_field("drift", *info.momentum_drift, 7, look));
    return fields;
}

// The model in force: its terms, or their names, or as many names as fit.
Field model_field(const HudInfo& info, int columns, const Look& look) {
    Field field{"model", "free discs", ink_of(Role::text, look), 3};
    if (info.terms.empty()) return field;
    field.value = fmt::format("{}", fmt::join(info.terms, ", "));
    std::vector<std::string> names;
    for (const std::string& term : info.terms)
        names.push_back(term.substr(0, term.find(' ')));
    for (std::size_t left_out = 0; width_of(field) > columns && !names.empty(); ++left_out) {
        if (left_out > 0) names.pop_back();
        field.value = fmt::format("{}", fmt::join(names, ", "));
        if (left_out > 0) field.value += fmt::format(" +{}", left_out);
    }
    return field;
}

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
    int write(int column, const Field& field) const {
        if (!field.label.empty()) {
            column = write(column, field.label + " ", ink_of(Role::faint, look));
        }
        return write(column, field.value, field.ink);
    }
    int write(int column, const std::vector<Field>& fields) const {
        for (const Field& field : fields)
            column = write(column, field) + gap;
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
std::string_view fitting_parts(std::string_view game, int columns) {
    while (columns_of(game) > columns) {
        const std::size_t last = game.rfind("  ");
        if (last == game.npos || last == 0) return cut_to(game, columns);
        game = game.substr(0, last);
    }
    return game;
}

void draw_physics(const Bar& bar, const HudInfo& info) {
    constexpr int least_model = 22;
    bar.clear();
    const int columns = bar.canvas.columns() - 2;
    if (info.beside.empty() && (info.is_game || !info.game.empty())) {
        const bool has_line = !info.game.empty();
        bar.write(1, fitting_parts(has_line ? info.game : info.goal, columns),
                  ink_of(has_line ? Role::text : Role::warning, bar.look));
        return;
    }
    std::vector<Field> fields = physics_fields(info, bar.look);
    fields.push_back(model_field(info, least_model, bar.look));
    fields = fitting_fields(std::move(fields), columns);
    if (!fields.empty() && fields.back().label == "model") {
        const int others = width_of(fields) - width_of(fields.back());
        fields.back() = model_field(info, columns - others, bar.look);
    }
    bar.write(1, fields);
}

// The title gets the room that the fields leave.
void draw_first(const Bar& bar, const HudInfo& info, std::vector<Field> fields) {
    bar.clear();
    const int columns = bar.canvas.columns();
    // Half of the line is for the title, if it is that long; in a narrow window, the least that it
    // needs.
    const int first = fields.empty() ? 0 : width_of(fields.front()) + gap;
    const int others = info.title_comes_first ? first + 2 : columns / 2 + 8;
    const int least_title = info.title_comes_first || columns >= 60
                                ? std::max(0, std::min(columns_of(info.title), columns - others))
                                : 0;
    fields =
        fitting_fields(std::move(fields), columns - 2 - (least_title > 0 ? least_title + gap : 0));
    const int room = columns - 2 - width_of(fields) - gap;
    int column = 1;
    if (room >= 4 && !info.title.empty()) {
        const std::string_view title = cut_to(info.title, room);
        column = bar.write(column, title, ink_of(Role::strong, bar.look)) + gap;
    }
    bar.write(column, fields);
}

void draw_hints(const Bar& bar, const HudInfo& info) {
    bar.clear();
    // A short window has no other line for this.
    const std::string& other = info.beside.empty() ? info.game : info.beside;
    if (hud_rows(bar.canvas.columns(), bar.canvas.rows()) == 2 && !other.empty()) {
        bar.write(1, fitting_parts(other, bar.canvas.columns() - 2),
                  ink_of(Role::warning, bar.look));
        return;
    }
    int column = 1;
    for (const KeyHelp& hint : info.hints) {
        const int width = columns_of(hint.keys) + 1 + columns_of(hint.what);
        if (column + width > bar.canvas.columns() - 1) break;
        column = bar.write(column, hint.keys, ink_of(Role::strong, bar.look)) + 1;
        column = bar.write(column, hint.what, ink_of(Role::faint, bar.look)) + gap;
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

// Over the last rows of the world, at most half of them, and as wide as the text is.
void draw_message(Canvas& canvas, int below, const HudInfo& info, const Look& look) {
    if (info.message.empty() || below <= 0) return;
    std::vector<std::string> lines = message_lines(info.message, canvas.columns() - 2);
    const auto room = static_cast<std::size_t>((below + 1) / 2);
    if (lines.size() > room) {
        lines.resize(room);
        if (!info.message_more.empty()) lines.back() = info.message_more;
    }
    int width = 0;
    for (const std::string& line : lines)
        width = std::max(width, columns_of(line));
    const Ink ink = ink_of(info.message_is_error ? Role::error : Role::warning, look);
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
    std::vector<Field> play = play_fields(info, look);
    draw_message(canvas, first, info, look);
    if (count == 0) return;
    if (count == 1) return draw_first(top, info, std::move(play));
    draw_first(top, info, std::move(play));
    if (count == 3) draw_physics({canvas, look, first + 1}, info);
    draw_hints({canvas, look, first + count - 1}, info);
}

}  // namespace carom
