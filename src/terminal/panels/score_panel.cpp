#include "terminal/panels/score_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/large_digits.h"
#include "terminal/panels/panel.h"

namespace carom {
namespace {

constexpr std::string_view wide_score = "1,000,000";
constexpr int least_rows_of_wide = 24;

// A dark pane behind a panel, where the terminal has colours for it.
void lay_pane(Canvas& canvas, const CellArea& area, const Look& look) {
    if (!look.has_shades() || look.light_background) return;
    const Color pane = ink_of_color({20, 22, 30}, look).color;
    for (int row = area.row; row < area.row + area.rows; ++row)
        for (int column = area.column; column < area.column + area.columns; ++column)
            if (canvas.holds(column, row) && canvas.at(column, row).background == default_color)
                canvas.at(column, row).background = pane;
}

class Writer {
  public:
    Writer(Canvas& canvas, const CellArea& area, const Look& look)
        : canvas_(canvas), area_(area), look_(look) {}

    int rows_left() const { return area_.rows - row_; }
    void skip() { ++row_; }
    void line(std::string_view text, const Ink& ink) {
        write_cut(canvas_, area_, row_++, text, ink);
    }
    /// Two texts in a row.
    void pair(std::string_view first, const Ink& first_ink, std::string_view second,
              const Ink& second_ink) {
        const int width = columns_of(first) + 2;
        write_cut(canvas_, area_, row_, first, first_ink);
        const CellArea rest{area_.column + width, area_.row, area_.columns - width, area_.rows};
        if (rest.columns > 0) write_cut(canvas_, rest, row_, second, second_ink);
        ++row_;
    }
    void score(std::string_view text) {
        const Ink ink = ink_of(Role::counter, look_);
        const int width = large_width(text);
        if (width > area_.columns || rows_left() < large_rows(look_)) return line(text, ink);
        // Twice as large where even a large score has room for it.
        const bool is_wide = 2 * std::max(width, large_width(wide_score)) <= area_.columns;
        const int scale = is_wide && rows_left() >= least_rows_of_wide ? 2 : 1;
        write_large(canvas_, area_.column, area_.row + row_, text, scale, ink, look_);
        row_ += scale * large_rows(look_);
    }
    // Light text on a bar as wide as the panel, noticeable from the corner of an eye.
    void call(std::string_view text, const Ink& ink) { bar(text, ink, reverse); }
    // A call three rows high, with spaces between its letters where there is room.
    void large_call(std::string_view text, const Ink& ink) {
        std::string spaced;
        for (const char letter : text)
            spaced += std::string(spaced.empty() ? "" : " ") + letter;
        const bool is_ascii =
            std::ranges::all_of(text, [](char letter) { return letter >= ' ' && letter <= '~'; });
        const bool is_spaced = is_ascii && columns_of(spaced) <= area_.columns;
        const auto attributes = static_cast<std::uint8_t>(bold | reverse);
        bar("", ink, attributes);
        bar(is_spaced ? spaced : text, ink, attributes);
        bar("", ink, attributes);
    }

  private:
    void bar(std::string_view text, const Ink& ink, std::uint8_t attributes) {
        const int width = std::min(columns_of(text), area_.columns);
        const int left = (area_.columns - width) / 2;
        std::string bar(static_cast<std::size_t>(left), ' ');
        bar += cut_to(text, area_.columns);
        bar.append(static_cast<std::size_t>(area_.columns - left - width), ' ');
        canvas_.write(area_.column, area_.row + row_++, bar, ink.color, default_color,
                      static_cast<std::uint8_t>(ink.attributes | attributes));
    }

    Canvas& canvas_;
    CellArea area_;
    const Look& look_;
    int row_ = 0;
};

}  // namespace

namespace {

// The table's lights, a row each: how far every mode has come.
void write_lights(Writer& writer, const std::vector<ScoreLight>& lights, const Look& look) {
    std::size_t most = 0;
    for (const ScoreLight& light : lights)
        most = std::max(most, light.lamps.size());
    writer.line("LIGHTS", ink_of(Role::faint, look));
    for (const ScoreLight& light : lights) {
        const bool is_lit = std::ranges::count(light.lamps, true) > 0;
        std::string lamps;
        for (const bool lamp : light.lamps)
            lamps += look.utf8 ? (lamp ? "●" : "·") : (lamp ? "#" : ".");
        lamps.append(most - light.lamps.size(), ' ');
        const Ink lamp_ink =
            is_lit && light.color ? ink_of_color(*light.color, look) : ink_of(Role::faint, look);
        const Ink name_ink = ink_of(light.is_wanted ? Role::warning
                                    : is_lit        ? Role::text
                                                    : Role::faint,
                                    look);
        writer.pair(lamps, lamp_ink, light.name, name_ink);
    }
}

// Lists that fill a high window, each only if all of it fits.
void write_lists(Writer& writer, const ScorePanel& panel, const Look& look) {
    const auto fits = [&](std::size_t rows, std::size_t after) {
        return rows > 0 && writer.rows_left() >= static_cast<int>(rows + after) + 2;
    };
    const std::size_t scores = panel.high_scores.empty() ? 0 : panel.high_scores.size() + 2;
    if (fits(panel.lights.size(), scores)) {
        writer.skip();
        write_lights(writer, panel.lights, look);
    }
    if (!fits(panel.balls.size(), scores)) return;
    writer.skip();
    writer.line("THIS GAME", ink_of(Role::faint, look));
    for (const std::string& line : panel.balls)
        writer.line(line, ink_of(Role::text, look));
}

void write_score_panel(Canvas& canvas, const CellArea& area, const ScorePanel& panel,
                       const Look& look) {
    const CellArea inside{area.column + 1, area.row, area.columns - 2, area.rows};
    Writer writer(canvas, inside, look);
    const Ink strong = ink_of(Role::strong, look);
    const Ink faint = ink_of(Role::faint, look);
    const bool is_roomy = area.rows >= 16;
    if (is_roomy) writer.skip();
    if (is_roomy) writer.line(panel.title, faint);
    if (is_roomy) writer.skip();
    writer.score(panel.score);
    writer.skip();
    for (const std::string& line : panel.lines)
        if (writer.rows_left() > 2) writer.line(line, ink_of(Role::text, look));
    if (is_roomy) writer.skip();
    for (const std::string& line : wrapped(panel.task, inside.columns))
        if (!line.empty() && writer.rows_left() > 2) writer.line(line, strong);
    // A large message takes the row above it, and the one below.
    const bool is_large = panel.moment != ScorePanel::Moment::plain && is_roomy &&
                          !panel.message.empty() && writer.rows_left() > 3;
    if (is_roomy && !panel.task.empty() && !is_large) writer.skip();
    if (is_large)
        writer.large_call(
            panel.message,
            ink_of(panel.moment == ScorePanel::Moment::large_bright ? Role::warning : Role::error,
                   look));
    else if (!panel.message.empty() && writer.rows_left() > 0)
        writer.call(panel.message, ink_of(Role::warning, look));
    else
        writer.skip();
    if (!panel.call.empty() && writer.rows_left() > 0)
        writer.call(panel.call, ink_of(Role::good, look));
    else if (!is_large)
        writer.skip();
    write_lists(writer, panel, look);
    if (panel.high_scores.empty() || writer.rows_left() < 3) return;
    writer.skip();
    writer.line("HIGH SCORES", faint);
    for (const ScoreLine& score : panel.high_scores) {
        if (writer.rows_left() < 1) return;
        writer.line(fmt::format("{:>2}  {:<3}  {:>13}", score.rank, score.name, score.score),
                    score.is_new ? strong : ink_of(Role::text, look));
    }
}

}  // namespace

void draw_score_panel(Canvas& canvas, const CellArea& area, const ScorePanel& panel,
                      const Look& look) {
    canvas.clear(area);
    if (area.columns < 4 || area.rows < 1) return;
    write_score_panel(canvas, area, panel, look);
    lay_pane(canvas, area, look);
}

namespace {

// "  lanes     all three: ...": a word, and from which column its text begins.
struct Entry {
    std::string word;
    std::string text;
};
std::optional<Entry> entry_of(std::string_view line) {
    if (!line.starts_with("  ") || line.starts_with("   ")) return std::nullopt;
    const std::size_t gap = line.find("  ", 2);
    if (gap == line.npos) return std::nullopt;
    const std::size_t text = line.find_first_not_of(' ', gap);
    if (text == line.npos) return std::nullopt;
    return Entry{std::string(line.substr(2, gap - 2)), std::string(line.substr(text))};
}

std::string trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first == line.npos ? std::string() : std::string(line.substr(first));
}

}  // namespace

void draw_rules_card(Canvas& canvas, const CellArea& area, std::string_view title,
                     const std::vector<std::string>& text, const Look& look) {
    canvas.clear(area);
    if (area.columns < 12 || area.rows < 4) return;
    const CellArea inside{area.column + 1, area.row + 1, area.columns - 2, area.rows - 1};
    int row = 0;
    const auto write = [&](std::string_view line, int indent, const Ink& ink) {
        const CellArea place{inside.column + indent, inside.row, inside.columns - indent,
                             inside.rows};
        if (row < inside.rows) write_cut(canvas, place, row, line, ink);
    };
    const auto flow = [&](const std::string& paragraph, int indent, const Ink& ink) {
        for (const std::string& line : wrapped(paragraph, inside.columns - indent)) {
            write(line, indent, ink);
            ++row;
        }
    };
    write(title, 0, ink_of(Role::strong, look));
    row += 2;
    constexpr int indent = 2;
    for (std::size_t i = 0; i < text.size();) {
        const std::string& line = text[i++];
        if (trimmed(line).empty()) {
            ++row;
            continue;
        }
        const std::optional<Entry> entry = entry_of(line);
        // Lines that are indented further go on with the entry; others with the paragraph.
        std::string whole = entry ? entry->text : trimmed(line);
        while (i < text.size() && !trimmed(text[i]).empty() && !entry_of(text[i]) &&
               text[i].starts_with("   ") == entry.has_value())
            whole += " " + trimmed(text[i++]);
        if (entry) {
            write(entry->word, 0, ink_of(Role::counter, look));
            ++row;
        }
        const bool is_goal = whole.starts_with("Goal:");
        flow(whole, entry ? indent : 0, ink_of(is_goal ? Role::warning : Role::text, look));
    }
    if (row > inside.rows) {
        row = inside.rows - 1;
        canvas.clear({inside.column, inside.row + row, inside.columns, 1});
        write("F1 shows the rest", 0, ink_of(Role::faint, look));
    }
    lay_pane(canvas, area, look);
}

}  // namespace carom
