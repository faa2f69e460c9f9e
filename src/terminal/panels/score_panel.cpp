#include "terminal/panels/score_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/panel.h"

namespace carom {
namespace {

constexpr int glyph_rows = 5;
constexpr std::string_view wide_score = "1,000,000";
constexpr int least_rows_of_wide = 24;

// Five rows of three dots each, from the top, the leftmost dot in the highest bit.
struct Glyph {
    char character = ' ';
    int columns = 3;
    std::array<std::uint8_t, glyph_rows> rows{};
};
constexpr std::array<Glyph, 11> glyphs = {{{'0', 3, {7, 5, 5, 5, 7}},
                                           {'1', 3, {2, 6, 2, 2, 7}},
                                           {'2', 3, {7, 1, 7, 4, 7}},
                                           {'3', 3, {7, 1, 3, 1, 7}},
                                           {'4', 3, {5, 5, 7, 1, 1}},
                                           {'5', 3, {7, 4, 7, 1, 7}},
                                           {'6', 3, {7, 4, 7, 5, 7}},
                                           {'7', 3, {7, 1, 1, 2, 2}},
                                           {'8', 3, {7, 5, 7, 5, 7}},
                                           {'9', 3, {7, 5, 7, 1, 7}},
                                           {',', 2, {0, 0, 0, 2, 4}}}};

const Glyph* glyph_of(char character) {
    const auto* found = std::ranges::find(glyphs, character, &Glyph::character);
    return found == glyphs.end() ? nullptr : found;
}

int width_of(std::string_view text) {
    int width = -1;
    for (const char character : text) {
        const Glyph* glyph = glyph_of(character);
        width += (glyph ? glyph->columns : 3) + 1;
    }
    return std::max(width, 0);
}

bool is_dot(const Glyph& glyph, int row, int column) {
    return row < glyph_rows && (glyph.rows[static_cast<std::size_t>(row)] >> (2 - column) & 1) != 0;
}

// The dots of a cell: one in ASCII, an upper and a lower one with half blocks.
char32_t cell_of(const Glyph& glyph, int row, int column, int scale, const Look& look) {
    if (!look.utf8) return is_dot(glyph, row / scale, column / scale) ? U'#' : U' ';
    const bool upper = is_dot(glyph, 2 * row / scale, column / scale);
    const bool lower = is_dot(glyph, (2 * row + 1) / scale, column / scale);
    return upper && lower ? U'█' : upper ? U'▀' : lower ? U'▄' : U' ';
}

int rows_of_digits(const Look& look) {
    return look.utf8 ? (glyph_rows + 1) / 2 : glyph_rows;
}

void write_large(Canvas& canvas, int column, int row, std::string_view text, int scale,
                 const Ink& ink, const Look& look) {
    for (const char character : text) {
        const Glyph* glyph = glyph_of(character);
        if (!glyph) continue;
        for (int down = 0; down < scale * rows_of_digits(look); ++down)
            for (int across = 0; across < scale * glyph->columns; ++across)
                canvas.put(column + across, row + down,
                           {cell_of(*glyph, down, across, scale, look), ink.color, default_color,
                            ink.attributes});
        column += scale * (glyph->columns + 1);
    }
}

// A dark pane behind a panel, where the terminal has colours for it.
void lay_pane(Canvas& canvas, const CellArea& area, const Look& look) {
    if (!look.has_shades() || look.light_background) return;
    const Color pane = ink_of_color({20, 22, 30}, look).color;
    for (int row = area.row; row < area.row + area.rows; ++row)
        for (int column = area.column; column < area.column + area.columns - 1; ++column)
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
    void score(std::string_view text) {
        const Ink ink = ink_of(Role::counter, look_);
        const int width = width_of(text);
        if (width > area_.columns || rows_left() < rows_of_digits(look_)) return line(text, ink);
        // Twice as large where even a large score has room for it.
        const bool is_wide = 2 * std::max(width, width_of(wide_score)) <= area_.columns;
        const int scale = is_wide && rows_left() >= least_rows_of_wide ? 2 : 1;
        write_large(canvas_, area_.column, area_.row + row_, text, scale, ink, look_);
        row_ += scale * rows_of_digits(look_);
    }
    // Light text on a bar as wide as the panel, noticeable from the corner of an eye.
    void call(std::string_view text, const Ink& ink) {
        const int width = std::min(columns_of(text), area_.columns);
        const int left = (area_.columns - width) / 2;
        std::string bar(static_cast<std::size_t>(left), ' ');
        bar += cut_to(text, area_.columns);
        bar.append(static_cast<std::size_t>(area_.columns - left - width), ' ');
        canvas_.write(area_.column, area_.row + row_++, bar, ink.color, default_color,
                      static_cast<std::uint8_t>(ink.attributes | reverse));
    }

  private:
    Canvas& canvas_;
    CellArea area_;
    const Look& look_;
    int row_ = 0;
};

}  // namespace

namespace {

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
    if (!panel.message.empty() && writer.rows_left() > 0)
        writer.call(panel.message, ink_of(Role::warning, look));
    else
        writer.skip();
    if (!panel.call.empty() && writer.rows_left() > 0)
        writer.call(panel.call, ink_of(Role::good, look));
    else
        writer.skip();
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
    clear_area(canvas, area);
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
    clear_area(canvas, area);
    if (area.columns < 12 || area.rows < 4) return;
    const CellArea inside{area.column + 1, area.row + 1, area.columns - 3, area.rows - 1};
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
    lay_pane(canvas, area, look);
}

}  // namespace carom
