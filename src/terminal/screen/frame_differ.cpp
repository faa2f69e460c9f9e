#include "terminal/screen/frame_differ.h"

#include <algorithm>
#include <span>
#include <utility>

#include "level/text/utf8.h"
#include "terminal/canvas/character_width.h"
#include "terminal/canvas/mosaic.h"

namespace carom {
namespace {

// The approximate cost, in bytes, of a style on a terminal without ECMA-48.
constexpr std::size_t foreign_cost = 12;
// At most this many unchanged cells between two changes are written again instead of a jump.
constexpr int longest_gap = 8;

// Of a cell of which it is not known what the terminal shows.
constexpr char32_t not_known = 0;

constexpr bool is_ascii(char32_t glyph) {
    return glyph >= U' ' && glyph < 0x7f;
}

// Underline and reverse show on blanks too.
bool is_marked(const SgrStyle& style) {
    return (style.attributes & (reverse | underline)) != 0;
}

std::size_t glyph_size(char32_t glyph) {
    return glyph < 0x80 ? 1 : glyph < 0x800 ? 2 : glyph < 0x10000 ? 3 : 4;
}

// Without colours, a bright background behind dark text is shown by reversing the cell.
bool has_bright_ground(const Cell& cell) {
    if (cell.background == default_color) return false;
    constexpr double own_ink = 0.9;  // luminance of the default foreground, on a dark terminal
    const double ink = cell.foreground < 0 ? own_ink : luminance(rgb_of(cell.foreground));
    return luminance(rgb_of(cell.background)) > ink;
}

}  // namespace

FrameDiffer::FrameDiffer(TerminalDialect dialect) : dialect_(std::move(dialect)) {}

void FrameDiffer::set_size(int columns, int rows) {
    columns_ = columns;
    rows_ = rows;
    redraw();
}

std::string_view FrameDiffer::paint(const Canvas& canvas) {
    out_.clear();
    const bool has_shape = canvas.columns() == canvas_.columns() && canvas.rows() == canvas_.rows();
    if (std::exchange(is_whole_due_, false) || !has_shape) begin_whole(canvas);
    if (dialect_.has_overhang) forget_overhang(canvas);
    for (int row = 0; row < std::min(rows_, canvas.rows()); ++row)
        paint_row(canvas, row);
    if (!dialect_.hides_cursor && !out_.empty()) reach(rows_ - 1, columns_ - 1);
    canvas_ = canvas;
    return out_;
}

void FrameDiffer::begin_whole(const Canvas& canvas) {
    style_.reset();
    take_style({});
    out_ += dialect_.clear;
    cursor_ = CursorPlace{0, 0};
    canvas_ = Canvas(canvas.columns(), canvas.rows());
    shown_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), Look{});
    wanted_.assign(static_cast<std::size_t>(columns_), Look{});
}

FrameDiffer::Look FrameDiffer::look_of(const Cell& cell) const {
    const bool is_shown = is_ascii(cell.glyph) || (dialect_.is_utf8 && is_one_column(cell.glyph));
    Look look{is_shown ? cell.glyph : U'?',
              {color_for_terminal(cell.foreground, dialect_.colors),
               color_for_terminal(cell.background, dialect_.colors), cell.attributes}};
    SgrStyle& style = look.style;
    if (dialect_.colors == 0 && has_bright_ground(cell)) style.attributes ^= reverse;
    style.attributes &= dialect_.attributes;
    const bool is_colored = style.foreground >= 0 || style.background >= 0;
    if (is_colored) style.attributes &= dialect_.attributes_in_color;
    if (is_marked(style)) return look;

    const bool is_plain = style.attributes == plain;
    const std::optional<char32_t> complement = complement_of(look.glyph);
    // A mosaic of one colour all over is sent as a blank of that colour: one byte, and no seam at
    // the cell's border, which blocks leave in many fonts.
    if (complement && style.background >= 0 && style.foreground == style.background) {
        look.glyph = U' ';
    }
    if (look.glyph == U' ') {
        style.foreground = default_color;
        style.attributes = plain;
    } else if (look.glyph == full_block && is_plain && style.foreground >= 0) {
        style.background = default_color;
    } else if (complement && *complement < look.glyph && is_plain && style.foreground >= 0 &&
               style.background >= 0) {
        // Of a mosaic and its complement in exchanged colours, one stands for both.
        look.glyph = *complement;
        std::swap(style.foreground, style.background);
    }
    return look;
}

void FrameDiffer::paint_row(const Canvas& canvas, int row) {
    const int width = std::min(columns_, canvas.columns());
    const std::span<Look> shown = std::span(shown_).subspan(index_of(row, 0), wanted_.size());
    for (int column = 0; column < width; ++column) {
        const auto i = static_cast<std::size_t>(column);
        const Cell& cell = canvas.at(column, row);
        const bool is_same = cell == canvas_.at(column, row) && shown[i].glyph != not_known;
        wanted_[i] = is_same ? shown[i] : look_of(cell);
    }
    if (!dialect_.waits_at_margin && row == rows_ - 1) wanted_.back() = shown.back();

    for (int column = next_change(row, 0); column < columns_; column = next_change(row, column)) {
        reach(row, column);
        const int after_blanks = paint_blanks(row, column);
        if (after_blanks > column) {
            column = after_blanks;
        } else {
            column += paint_cells(row, column);
        }
    }
    std::ranges::copy(wanted_, shown.begin());
}

// Where a block goes, its neighbours may keep pixels of it, so they are drawn again.
void FrameDiffer::forget_overhang(const Canvas& canvas) {
    const int width = std::min(columns_, canvas.columns());
    const int height = std::min(rows_, canvas.rows());
    const auto forget = [&](int row, int column) {
        if (row < 0 || row >= height || column < 0 || column >= width) return;
        if (canvas.at(column, row) == canvas_.at(column, row))
            shown_[index_of(row, column)].glyph = not_known;
    };
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Cell& before = canvas_.at(column, row);
            if (before.glyph == U' ' || !complement_of(before.glyph) ||
                before == canvas.at(column, row))
                continue;
            forget(row, column - 1);
            forget(row, column + 1);
            forget(row - 1, column);
            forget(row + 1, column);
        }
    }
}

std::size_t FrameDiffer::index_of(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
}

// The next changed column from `column` on; the number of columns if there is none.
int FrameDiffer::next_change(int row, int column) const {
    const std::size_t start = index_of(row, 0);
    while (column < columns_ && wanted(column) == shown_[start + static_cast<std::size_t>(column)])
        ++column;
    return column;
}

// The run of cells that look like the one at `column`.
FrameDiffer::Run FrameDiffer::run_from(int row, int column) const {
    Run run{column, column};
    for (; run.end < columns_ && wanted(run.end) == wanted(column); ++run.end) {
        const bool is_changed = wanted(run.end) != shown_[index_of(row, run.end)];
        if (is_changed) run.last_change = run.end + 1;
    }
    return run;
}

// Brings the cursor to a cell, by writing the cells in between again where that is shorter.
void FrameDiffer::reach(int row, int column) {
    const int from = cursor_ && cursor_->row == row ? cursor_->column : column + 1;
    if (from < column && column - from <= longest_gap) {
        std::optional<SgrStyle> style = style_;
        std::size_t cost = 0;
        for (int i = from; i < column; ++i) {
            const Way way = way_of(wanted(i), style);
            cost += way.cost;
            style = way.style;
        }
        cost += way_of(wanted(column), style).cost;
        if (cost <=
            sideways_size(dialect_, columns_, from, column) + way_of(wanted(column), style_).cost) {
            for (int i = from; i < column; ++i)
                write(way_of(wanted(i), style_));
        }
    }
    const CursorPlace place{row, column};
    if (cursor_ != place) append_movement(out_, dialect_, columns_, cursor_, place);
    cursor_ = place;
}

// Erases the run of blanks at `column` where that is shorter than writing them. Returns how many it
// erased. The cursor stays.
int FrameDiffer::paint_blanks(int row, int column) {
    const Look& look = wanted(column);
    const bool can_erase = look.style.background < 0 || dialect_.erases_in_color;
    if (look.glyph != U' ' || is_marked(look.style) || !can_erase) return column;
    const Run run = run_from(row, column);
    const int count = run.last_change - column;
    const std::size_t written = static_cast<std::size_t>(count);
    if (dialect_.has_erase_line && run.end == columns_ && written > 3) {
        take_style(way_of(look, style_).style);
        out_ += "\033[K";
        return columns_;
    }
    if (!dialect_.has_erase_cells) return column;
    const int next = next_change(row, run.last_change);
    const bool is_last = next == columns_;
    const std::size_t erasing =
        sequence_size(count) + (is_last ? 0 : sideways_size(dialect_, columns_, column, next));
    if (erasing >=
        written + (is_last ? 0 : sideways_size(dialect_, columns_, run.last_change, next)))
        return column;
    take_style(way_of(look, style_).style);
    append_sequence(out_, count, 'X');
    return run.last_change;
}

// Writes the cell at `column`, and equal cells behind it where one sequence repeats it. Returns how
// many cells it wrote.
int FrameDiffer::paint_cells(int row, int column) {
    write(way_of(wanted(column), style_));
    if (!dialect_.has_repeat || !is_ascii(wanted(column).glyph)) return 1;
    const int more = run_from(row, column).last_change - column - 1;
    // libvterm 0.3 puts the cursor at the margin when a repetition ends one column before it.
    const bool reaches_margin = column + 1 + more >= columns_ - 1;
    if (reaches_margin || static_cast<std::size_t>(more) <= sequence_size(more)) return 1;
    append_sequence(out_, more, 'b');
    cursor_->column += more;
    return 1 + more;
}

// The cheapest way to show a look. Colours that are not visible are left as they are.
FrameDiffer::Way FrameDiffer::way_of(const Look& look, const std::optional<SgrStyle>& style) const {
    Way best{look.glyph, look.style, style_cost(style, look.style) + glyph_size(look.glyph)};
    if (best.cost <= 3 || !style || is_marked(look.style)) return best;
    const auto offer = [&](char32_t glyph, const SgrStyle& other) {
        const std::size_t cost = style_cost(style, other) + glyph_size(glyph);
        // At equal cost the background in force stays: in xterm a background reaches into the next
        // cell, where that of its neighbours shows least.
        const bool is_calmer =
            other.background == style->background && best.style.background != style->background;
        if (cost < best.cost || (cost == best.cost && is_calmer)) best = {glyph, other, cost};
    };
    const SgrStyle& own = look.style;
    if (look.glyph == U' ' && !is_marked(*style)) {
        offer(U' ', {style->foreground, own.background, style->attributes});
    }
    if (own.attributes != plain || own.foreground < 0) return best;
    if (look.glyph == full_block) {
        offer(full_block, {own.foreground, style->background, plain});
        offer(U' ', {style->foreground, own.foreground, plain});
    }
    if (own.background >= 0 && look.glyph != U' ' && look.glyph != full_block) {
        if (const auto complement = complement_of(look.glyph))
            offer(*complement, {own.background, own.foreground, plain});
    }
    return best;
}

std::size_t FrameDiffer::style_cost(const std::optional<SgrStyle>& from, const SgrStyle& to) const {
    if (from == to) return 0;
    if (dialect_.style) return foreign_cost;
    return style_change(from, to, dialect_.has_own_colors).size();
}

void FrameDiffer::take_style(const SgrStyle& style) {
    if (style_ == style) return;
    if (dialect_.style) {
        out_ += dialect_.style(style);
    } else {
        out_ += style_change(style_, style, dialect_.has_own_colors).text();
    }
    style_ = style;
}

void FrameDiffer::write(const Way& way) {
    take_style(way.style);
    append_utf8(out_, way.glyph);
    ++cursor_->column;
    if (cursor_->column == columns_ && !dialect_.waits_at_margin) cursor_.reset();
}

}  // namespace carom
