#include "terminal/screen_curses.h"

#define NCURSES_NOMACROS 1
#define NCURSES_WIDECHAR 1
#include <curses.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>
#include <wchar.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "terminal/capabilities.h"
#include "terminal/screen_terminfo.h"

namespace carom {
namespace {

constexpr int palette = 256;
// A gap of unchanged cells shorter than this joins two spans: ncurses compares anyway.
constexpr int short_gap = 8;

/// The numbers that ncurses gives to pairs of colours, handed out as they come up.
class ColorPairs {
  public:
    ColorPairs() : pairs_(static_cast<std::size_t>((palette + 1) * (palette + 1)), 0) {}

    /// The pair for two colours of the terminal, -1 being its own. When all are in use: that of the
    /// foreground alone, else 0, the terminal's own colours.
    int number(int foreground, int background, int slot_foreground, int slot_background) {
        int& pair = slot(slot_foreground, slot_background);
        if (pair != 0 || (foreground < 0 && background < 0)) return pair;
        if (next_ >= std::min(COLOR_PAIRS, most_pairs) ||
            init_extended_pair(next_, foreground, background) == ERR) {
            return slot(slot_foreground, default_color);
        }
        pair = next_++;
        return pair;
    }

  private:
    static constexpr int most_pairs = 32767;

    int& slot(int foreground, int background) {
        return pairs_[static_cast<std::size_t>((foreground + 1) * (palette + 1) + background + 1)];
    }

    std::vector<int> pairs_;
    int next_ = 1;
};

attr_t attributes_of(std::uint8_t attributes) {
    attr_t result = A_NORMAL;
    if ((attributes & bold) != 0) result |= A_BOLD;
    if ((attributes & dim) != 0) result |= A_DIM;
    if ((attributes & reverse) != 0) result |= A_REVERSE;
    if ((attributes & underline) != 0) result |= A_UNDERLINE;
    return result;
}

// Without colours, a bright background behind dark text is told by reversing the cell.
bool is_reversed(const Cell& cell) {
    if (cell.background == default_color) return false;
    const double ink = cell.foreground < 0 ? 0.9 : luminance(rgb_of(cell.foreground));
    return luminance(rgb_of(cell.background)) > ink;
}

wchar_t character_of(char32_t glyph, bool utf8) {
    const bool is_ascii = glyph >= U' ' && glyph < 0x7f;
    if (is_ascii) return static_cast<wchar_t>(glyph);
    return utf8 && wcwidth(static_cast<wchar_t>(glyph)) == 1 ? static_cast<wchar_t>(glyph) : L'?';
}

int memory_file() {
#ifdef __linux__
    return memfd_create("frame", MFD_CLOEXEC);
#else
    std::FILE* const file = std::tmpfile();
    return file == nullptr ? -1 : dup(fileno(file));
#endif
}

}  // namespace

struct Curses::State {
    SCREEN* screen = nullptr;
    std::FILE* output = nullptr;  // what ncurses writes to: the terminal, or the memory
    int terminal = -1;            // a handle of its own on the terminal
    int memory = -1;
    int colors = 0;
    ColorPairs pairs;
    Canvas shown;
    bool is_whole_due = true;
    bool is_left = false;
    std::string bytes;
    std::vector<cchar_t> span;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (screen != nullptr) delscreen(screen);
        if (output != nullptr) std::fclose(output);
        if (terminal >= 0) ::close(terminal);
        if (memory >= 0) ::close(memory);
    }

    void write_to(int handle) const { dup2(handle, fileno(output)); }

    cchar_t curses_cell(const Cell& cell, bool utf8) {
        const wchar_t text[2] = {character_of(cell.glyph, utf8), L'\0'};
        attr_t attributes = attributes_of(cell.attributes);
        int pair = 0;
        if (colors == 0) {
            if (is_reversed(cell)) attributes ^= A_REVERSE;
        } else {
            pair = pairs.number(color_for_terminal(cell.foreground, colors),
                                color_for_terminal(cell.background, colors), slot(cell.foreground),
                                slot(cell.background));
        }
        cchar_t result{};
        setcchar(&result, text, attributes, static_cast<short>(pair), &pair);
        return result;
    }

    // Where a colour's pairs are kept: colours that look the same on this terminal share them.
    int slot(Color color) const {
        if (color < 0) return default_color;
        return colors > palette ? std::min<int>(color, palette - 1)
                                : color_for_terminal(color, colors);
    }

    void put_span(const Canvas& canvas, int row, int first, int end, bool utf8) {
        span.clear();
        for (int column = first; column < end; ++column) {
            span.push_back(curses_cell(canvas.at(column, row), utf8));
        }
        mvwadd_wchnstr(stdscr, row, first, span.data(), static_cast<int>(span.size()));
    }

    void put_changes(const Canvas& canvas, int row, int columns, bool utf8) {
        int first = -1;  // of the span that is being gathered; -1: none
        int end = 0;
        for (int column = 0; column < columns; ++column) {
            if (!is_whole_due && canvas.at(column, row) == shown.at(column, row)) continue;
            if (first >= 0 && column - end >= short_gap) {
                put_span(canvas, row, first, end, utf8);
                first = -1;
            }
            if (first < 0) first = column;
            end = column + 1;
        }
        if (first >= 0) put_span(canvas, row, first, end, utf8);
    }

    // What doupdate() writes, taken out of the memory.
    void update() {
        lseek(memory, 0, SEEK_SET);
        doupdate();
        const off_t length = lseek(memory, 0, SEEK_CUR);
        bytes.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
        if (pread(memory, bytes.data(), bytes.size(), 0) < 0) bytes.clear();
    }
};

std::variant<Curses, std::string> Curses::start(const char* term, int most_colors) {
    auto state = std::make_unique<State>();
    state->terminal = dup(STDOUT_FILENO);
    state->memory = memory_file();
    state->output = fdopen(dup(STDOUT_FILENO), "w");
    if (state->terminal < 0 || state->memory < 0 || state->output == nullptr) {
        return std::string("too few files may be open");
    }
    constexpr const char* common = "xterm-256color";
    const bool is_named = term != nullptr && *term != '\0';
    if (is_named) state->screen = newterm(term, state->output, stdin);
    if (state->screen == nullptr) state->screen = newterm(common, state->output, stdin);
    if (state->screen == nullptr) {
        return fmt::format(
            "the terminal '{}' is not known here: set TERM to one that is, such as vt100, or "
            "install its description (on Debian the package ncurses-term)",
            is_named ? term : "");
    }
    if (!has_capability("cup")) {
        endwin();
        return fmt::format(
            "the terminal '{}' cannot place characters: set TERM to what it really is, such as "
            "xterm-256color or vt100",
            is_named ? term : common);
    }
    raw();
    noecho();
    nonl();
    keypad(stdscr, TRUE);
    leaveok(stdscr, TRUE);
    typeahead(-1);
    curs_set(0);
    if (most_colors >= 8 && has_colors() && start_color() != ERR && COLORS >= 8) {
        use_default_colors();
        const int known = COLORS > palette    ? COLORS
                          : COLORS >= palette ? palette
                          : COLORS >= 16      ? 16
                                              : 8;
        state->colors =
            most_colors >= palette ? known : std::min(known, most_colors >= 16 ? 16 : 8);
    }
    // Until the first time that it comes back from endwin(), ncurses writes at every cursor move.
    endwin();
    refresh();
    state->write_to(state->memory);
    return Curses(std::move(state));
}

Curses::Curses(std::unique_ptr<State> state) : state_(std::move(state)) {}
Curses::Curses(Curses&&) noexcept = default;
Curses& Curses::operator=(Curses&&) noexcept = default;
Curses::~Curses() {
    if (state_ != nullptr) leave();
}

int Curses::colors() const {
    return state_->colors;
}

bool Curses::is_modern() const {
    return has_capability("smcup") && tigetnum("colors") >= 8;
}

int Curses::columns() const {
    return COLS;
}
int Curses::rows() const {
    return LINES;
}

void Curses::set_size(int columns, int rows) {
    resize_term(rows, columns);
    redraw();
}

void Curses::redraw() {
    state_->is_whole_due = true;
}

std::string_view Curses::paint(const Canvas& canvas, bool utf8) {
    State& state = *state_;
    if (state.is_left) return {};
    const bool has_same_size =
        canvas.columns() == state.shown.columns() && canvas.rows() == state.shown.rows();
    if (!has_same_size) state.is_whole_due = true;
    if (state.is_whole_due) {
        werase(stdscr);
        clearok(curscr, TRUE);
    }
    const int columns = std::min(canvas.columns(), COLS);
    for (int row = 0; row < std::min(canvas.rows(), LINES); ++row) {
        state.put_changes(canvas, row, columns, utf8);
    }
    wnoutrefresh(stdscr);
    state.update();
    state.shown = canvas;
    state.is_whole_due = false;
    return state.bytes;
}

void Curses::leave() {
    if (std::exchange(state_->is_left, true)) return;
    state_->write_to(state_->terminal);
    endwin();
}

void Curses::enter() {
    if (!std::exchange(state_->is_left, false)) return;
    refresh();
    state_->write_to(state_->memory);
    redraw();
}

}  // namespace carom
