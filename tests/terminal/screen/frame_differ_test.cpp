#include "terminal/screen/frame_differ.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "support/emulator.h"
#include "terminal/canvas/mosaic.h"

using namespace carom;
using carom::test::CellLook;
using carom::test::described;
using carom::test::Emulator;

namespace {

/// A small window that has been drawn once and is blank.
struct Window {
    FrameDiffer differ;
    Canvas canvas;

    explicit Window(int columns, int rows, const TerminalDialect& dialect = {})
        : differ(dialect), canvas(columns, rows) {
        differ.set_size(columns, rows);
        differ.paint(canvas);
    }
    std::string frame() { return std::string(differ.paint(canvas)); }
};

void fill_row(Canvas& canvas, int row, const Cell& cell) {
    for (int column = 0; column < canvas.columns(); ++column)
        canvas.put(column, row, cell);
}

// A fixed sequence of numbers.
class Dice {
  public:
    int below(int limit) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(limit));
    }

  private:
    std::uint64_t state_ = 11;
};

Cell random_cell(Dice& dice, bool has_direct) {
    constexpr std::u32string_view glyphs =
        U"    "
        U"xxo#-\u2588\u2580\u2584\u2580\u28ff\U0001FB00\U0001FB3B\U0001CD00\U0001CDE3\U0001CD05";
    Cell cell;
    cell.glyph = glyphs[static_cast<std::size_t>(dice.below(static_cast<int>(glyphs.size())))];
    const auto color = [&]() -> Color {
        if (has_direct && dice.below(4) == 0) return direct_color({dice.below(3) * 100, 9, 200});
        return static_cast<Color>(dice.below(4) * 5 + dice.below(2) * 60);
    };
    if (dice.below(3) != 0) cell.foreground = color();
    if (dice.below(2) != 0) cell.background = color();
    if (dice.below(6) == 0) cell.attributes = static_cast<std::uint8_t>(dice.below(16));
    return cell;
}

void change_at_random(Canvas& canvas, Dice& dice, bool has_direct) {
    if (dice.below(12) == 0)
        canvas.fill(dice.below(2) == 0 ? Cell{} : random_cell(dice, has_direct));
    for (int change = dice.below(25); change >= 0; --change) {
        const Cell cell = random_cell(dice, has_direct);
        const int column = dice.below(canvas.columns());
        const int row = dice.below(canvas.rows());
        for (int i = dice.below(3) == 0 ? dice.below(30) : dice.below(3); i >= 0; --i)
            canvas.put(column + i, row, cell);
    }
}

// Of a mosaic and its complement in exchanged colours, which look alike, one; a mosaic of one
// colour is a blank.
std::string described_alike(CellLook look) {
    const bool is_marked = look.is_underlined || look.is_reversed;
    const auto complement = complement_of(look.glyph);
    if (complement && !is_marked && look.background >= 0) {
        if (look.foreground == look.background) look.glyph = U' ';
        if (*complement < look.glyph && !look.is_bold && look.foreground >= 0) {
            look.glyph = *complement;
            std::swap(look.foreground, look.background);
        }
    }
    return described(look);
}

std::string wanted_look(const Cell& cell) {
    return described_alike({.glyph = cell.glyph,
                            .foreground = cell.foreground,
                            .background = cell.background,
                            .is_bold = (cell.attributes & bold) != 0,
                            .is_underlined = (cell.attributes & underline) != 0,
                            .is_reversed = (cell.attributes & reverse) != 0});
}

// Shows random pictures, in windows of two sizes, and compares every cell of each.
void check_random_pictures(const TerminalDialect& dialect) {
    Dice dice;
    for (const int columns : {40, 23}) {
        constexpr int rows = 9;
        Emulator terminal(columns, rows, {}, [](std::string_view) {});
        FrameDiffer differ(dialect);
        differ.set_size(columns, rows);
        Canvas canvas(columns, rows);
        terminal.write("left over from before\r\n\033[41mcoloured");
        int wrong = 0;
        for (int frame = 0; frame < 300 && wrong == 0; ++frame) {
            change_at_random(canvas, dice, dialect.colors == direct_colors);
            if (dice.below(30) == 0) differ.redraw();
            const std::string bytes(differ.paint(canvas));
            terminal.write(bytes);
            for (int row = 0; row < rows; ++row) {
                for (int column = 0; column < columns; ++column) {
                    const bool is_corner = row == rows - 1 && column == columns - 1;
                    if (is_corner && !dialect.waits_at_margin) continue;
                    const std::string shown = described_alike(terminal.look(column, row));
                    const std::string wanted = wanted_look(canvas.at(column, row));
                    if (shown == wanted) continue;
                    if (++wrong > 3) continue;
                    CAPTURE(bytes);
                    CAPTURE(frame);
                    CAPTURE(column);
                    CAPTURE(row);
                    CHECK(shown == wanted);
                }
            }
        }
        CHECK(wrong == 0);
    }
}

}  // namespace

TEST_CASE("the first frame assumes nothing, and a frame without changes is empty") {
    FrameDiffer differ;
    differ.set_size(10, 3);
    Canvas canvas(10, 3);
    canvas.write(2, 1, "ab", 3);
    CHECK(differ.paint(canvas) == "\033[m\033[H\033[2J\033[3G\n\033[33mab");
    CHECK(differ.paint(canvas) == "");
    differ.redraw();
    CHECK(differ.paint(canvas) == "\033[m\033[H\033[2J\033[3G\n\033[33mab");
}

TEST_CASE("found 26: a cursor that cannot be hidden waits in the last cell") {
    TerminalDialect dialect;
    dialect.hides_cursor = false;
    Window window(20, 5, dialect);
    window.canvas.write(2, 1, "text");
    CHECK(window.frame().ends_with("\033[5;20H"));
    CHECK(window.frame().empty());
}

TEST_CASE("the style of a frame lasts into the next") {
    Window window(20, 3);
    window.canvas.write(0, 0, "x", 94);
    CHECK(window.frame() == "\033[38;5;94mx");
    window.canvas.write(1, 0, "y", 94);
    CHECK(window.frame() == "y");
}

TEST_CASE("only visible colours are sent") {
    Window window(20, 3);
    window.canvas.write(0, 0, "x   y", 1);
    // Blanks show no ink, so writing them is as good as a jump.
    CHECK(window.frame() == "\033[31mx   y");
    window.canvas.write(0, 0, "z ", 1);
    CHECK(window.frame() == "\rz");
}

TEST_CASE("of two equivalent looks, the one that suits the colours in force is sent") {
    Window window(20, 3);
    window.canvas.put(0, 0, {U'\u2580', 1, 2});
    window.canvas.put(1, 0, {U'\u2584', 2, 1});
    CHECK(window.frame() == "\033[31;42m\u2580\u2580");
    window.canvas.put(2, 0, {U'\u2588', 2});  // the background has that colour
    CHECK(window.frame() == " ");
    window.canvas.put(3, 0, {U'\u2588', 1});  // and the foreground has this one
    CHECK(window.frame() == "\u2588");
    window.canvas.put(4, 0, {U'\u2588', 3, 3});  // one colour all over: no seam at the border
    CHECK(window.frame() == "\033[43m ");
}

TEST_CASE("where blocks overhang, the neighbours of one that goes are drawn again") {
    const auto frame = [](bool has_overhang) {
        TerminalDialect dialect;
        dialect.has_overhang = has_overhang;
        Window window(9, 3, dialect);
        window.canvas.put(4, 0, {U'b', 1});
        window.canvas.put(4, 1, {U'\u2584', 1});
        window.canvas.put(5, 1, {U'c', 1});
        window.frame();
        window.canvas.put(4, 1, {U' '});
        return window.frame();
    };
    const auto has = [](const std::string& text, char what) {
        return text.find(what) != std::string::npos;
    };
    CHECK(has(frame(true), 'b'));
    CHECK(has(frame(true), 'c'));
    CHECK_FALSE(has(frame(false), 'b'));
    CHECK_FALSE(has(frame(false), 'c'));
}

TEST_CASE("a short gap is rewritten, a long one is jumped over") {
    Window window(40, 2);
    window.canvas.write(0, 0, "abcdefghijkl");
    window.frame();
    window.canvas.write(0, 0, "AbC");
    window.canvas.write(11, 0, "L");
    CHECK(window.frame() == "\rAbC\033[8CL");
}

TEST_CASE("runs of blanks are erased, in the colour in force") {
    Window window(40, 3);
    fill_row(window.canvas, 0, {U'x', default_color, 4});
    fill_row(window.canvas, 1, {U'x', default_color, 4});
    window.frame();
    fill_row(window.canvas, 0, {U' ', default_color, 4});
    CHECK(window.frame() == "\033[H\033[K");
    for (int column = 5; column < 25; ++column)
        window.canvas.put(column, 1, {});
    CHECK(window.frame() == "\033[6G\n\033[m\033[20X");
    SUBCASE("on a terminal that erases only in its own colour, colours are written") {
        TerminalDialect dialect;
        dialect.erases_in_color = false;
        Window other(10, 1, dialect);
        fill_row(other.canvas, 0, {U' ', default_color, 4});
        CHECK(other.frame() == "\033[44m          ");
        fill_row(other.canvas, 0, {});
        CHECK(other.frame() == "\r\033[m\033[K");
    }
}

TEST_CASE("runs of one ASCII character are repeated") {
    Window window(40, 2);
    for (int column = 0; column < 30; ++column) {
        window.canvas.put(column, 0, {U'-'});
        window.canvas.put(column, 1, {U'\u2500'});
    }
    const std::string frame = window.frame();
    CHECK(frame.starts_with("-\033[29b\r\n\u2500\u2500"));
}

TEST_CASE("underline and reverse show on blanks") {
    Window window(10, 1);
    window.canvas.put(0, 0, {U' ', default_color, default_color, underline});
    window.canvas.put(1, 0, {U' ', default_color, default_color, reverse});
    window.canvas.put(2, 0, {U'x'});
    CHECK(window.frame() == "\033[4m \033[0;7m \033[mx");
}

TEST_CASE("without colours, a bright background is shown by reversing the cell") {
    TerminalDialect dialect;
    dialect.colors = 0;
    Window window(10, 1, dialect);
    window.canvas.put(0, 0, {U'x', 0, 15});
    window.canvas.put(1, 0, {U'x', 15, 0});
    CHECK(window.frame() == "\033[7mx\033[mx");
}

TEST_CASE("attributes that the terminal lacks, or cannot combine with colours, are left out") {
    TerminalDialect dialect;
    dialect.attributes = bold | underline;
    dialect.attributes_in_color = bold | dim | reverse;
    Window window(10, 1, dialect);
    window.canvas.put(0, 0, {U'a', default_color, default_color, reverse | underline});
    window.canvas.put(1, 0, {U'b', 1, default_color, bold | underline});
    CHECK(window.frame() == "\033[4ma\033[0;1;31mb");
}

TEST_CASE("cells outside the window are not sent, and a terminal that scrolls keeps its corner") {
    TerminalDialect dialect;
    dialect.waits_at_margin = false;
    FrameDiffer differ(dialect);
    differ.set_size(4, 2);
    Canvas canvas(8, 5);
    canvas.fill({U'x'});
    const std::string frame(differ.paint(canvas));
    CHECK(std::count(frame.begin(), frame.end(), 'x') == 7);
}

TEST_CASE("without UTF-8 everything but ASCII is a question mark") {
    TerminalDialect dialect;
    dialect.is_utf8 = false;
    Window window(10, 1, dialect);
    window.canvas.write(0, 0, "a\u2588\u28ffb");
    CHECK(window.frame() == "a??b");
}

TEST_CASE("random pictures arrive cell by cell") {
    TerminalDialect dialect;
    SUBCASE("xterm") {}
    SUBCASE("24-bit colours") {
        dialect.colors = direct_colors;
    }
    SUBCASE("a VT100") {
        dialect.has_erase_cells = dialect.has_repeat = dialect.has_row = dialect.has_column = false;
        dialect.has_own_colors = false;
    }
    SUBCASE("one that erases in its own colour") {
        dialect.erases_in_color = false;
    }
    SUBCASE("one that does not wait at the margin") {
        dialect.waits_at_margin = false;
    }
    SUBCASE("one with strings of its own") {
        dialect.has_erase_line = dialect.has_erase_cells = dialect.has_repeat = false;
        dialect.move = [](int row, int column) {
            return fmt::format("\033[{};{}f", row + 1, column + 1);
        };
        dialect.style = [](const SgrStyle& style) {
            return std::string(style_change(std::nullopt, style, false).text());
        };
    }
    check_random_pictures(dialect);
}
