#include "terminal/screen/screen_curses.h"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "terminal/screen/screen_cells.h"
#include "terminal/screen/screen_style.h"
#include "terminal/screen/screen_terminfo.h"

namespace carom {
namespace {

// A terminal of more than 256 colours has numbers for red, green and blue.
int colors_in_use(int known, int most) {
    if (most >= 256 && known >= 256) return known;
    return std::min(known, most) >= 16 ? 16 : 8;
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
    bool is_utf8 = false;
    CursesCells cells;
    StyleFilter styles;
    bool is_whole_due = true;
    bool is_left = false;
    std::string bytes;

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

    // What doupdate() writes, taken out of the memory.
    void update() {
        lseek(memory, 0, SEEK_SET);
        doupdate();
        const off_t length = lseek(memory, 0, SEEK_CUR);
        bytes.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
        if (pread(memory, bytes.data(), bytes.size(), 0) < 0) bytes.clear();
        bytes = styles.filtered(bytes);
    }
};

std::variant<Curses, std::string> Curses::start(const std::string& term, int most_colors,
                                                bool utf8) {
    auto state = std::make_unique<State>();
    state->terminal = dup(STDOUT_FILENO);
    state->memory = memory_file();
    state->output = fdopen(dup(STDOUT_FILENO), "w");
    if (state->terminal < 0 || state->memory < 0 || state->output == nullptr) {
        return std::string("too few files may be open");
    }
    constexpr const char* common = "xterm-256color";
    const bool is_usable = !term.empty() && is_described(term.c_str());
    const char* const used = is_usable ? term.c_str() : common;
    if (is_described(used)) state->screen = newterm(used, state->output, stdin);
    if (state->screen == nullptr) {
        return fmt::format(
            "the terminal '{}' is not known here: set TERM to one that is, such as vt100, or "
            "install its description (on Debian the package ncurses-term)",
            term);
    }
    if (!has_capability("cup")) {
        endwin();
        return fmt::format(
            "the terminal '{}' cannot place characters: set TERM to what it really is, such as "
            "xterm-256color or vt100",
            used);
    }
    raw();
    noecho();
    nonl();
    leaveok(stdscr, TRUE);
    typeahead(-1);
    curs_set(0);
    if (most_colors >= 8 && has_colors() && start_color() != ERR && COLORS >= 8) {
        use_default_colors();
        state->colors = colors_in_use(COLORS, most_colors);
    }
    state->is_utf8 = utf8;
    state->styles = StyleFilter(has_own_colors());
    // Until it has come back from endwin() once, ncurses writes at every move of the cursor. The
    // terminal need not see that.
    state->write_to(state->memory);
    endwin();
    refresh();
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

std::string_view Curses::paint(const Canvas& canvas) {
    State& state = *state_;
    if (state.is_left) return {};
    if (std::exchange(state.is_whole_due, false) || !state.cells.has_shape_of(canvas)) {
        state.cells.forget(canvas);
        state.styles.distrust();  // what has written over the screen has its own colours
        werase(stdscr);
        clearok(curscr, TRUE);
    }
    state.cells.put(canvas, state.colors, state.is_utf8);
    wnoutrefresh(stdscr);
    state.update();
    return state.bytes;
}

void Curses::leave() {
    if (std::exchange(state_->is_left, true)) return;
    state_->write_to(state_->terminal);
    // ncurses takes the terminal to be in no style, but the filter is not always that quick.
    const std::string plain_style = plain_style_bytes();
    [[maybe_unused]] const ssize_t written =
        write(state_->terminal, plain_style.data(), plain_style.size());
    state_->styles.forget();
    endwin();
}

void Curses::enter() {
    if (!std::exchange(state_->is_left, false)) return;
    refresh();
    state_->write_to(state_->memory);
    redraw();
}

}  // namespace carom
