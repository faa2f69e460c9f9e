#include "terminal/screen/curses_session.h"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "terminal/screen/terminfo.h"

namespace carom {
namespace {

// While it exists, a variable of the environment has this value.
class TemporaryVariable {
  public:
    TemporaryVariable(const char* name, const std::string& value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    TemporaryVariable(const TemporaryVariable&) = delete;
    TemporaryVariable& operator=(const TemporaryVariable&) = delete;
    ~TemporaryVariable() {
        if (before_)
            setenv(name_, before_->c_str(), 1);
        else
            unsetenv(name_);
    }

  private:
    const char* name_;
    std::optional<std::string> before_;
};

// ncurses takes the window size from here rather than from the system: where the system reports an
// absurd size, newterm() would fail. Start with the real size: newterm() sends it to the terminal.
class StatedSize {
  public:
    StatedSize(int columns, int rows)
        : columns_("COLUMNS", std::to_string(columns)), rows_("LINES", std::to_string(rows)) {
        use_tioctl(FALSE);
    }

  private:
    TemporaryVariable columns_;
    TemporaryVariable rows_;
};

}  // namespace

struct CursesSession::State {
    SCREEN* screen = nullptr;
    std::FILE* output = nullptr;  // the terminal, separate from stdout and its buffer
    bool is_left = false;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (screen != nullptr) delscreen(screen);
        if (output != nullptr) std::fclose(output);
    }
};

std::variant<CursesSession, std::string> CursesSession::start(const std::string& term, int columns,
                                                              int rows) {
    auto state = std::make_unique<State>();
    state->output = fdopen(dup(STDOUT_FILENO), "w");
    if (state->output == nullptr) return std::string("too few files may be open");
    constexpr const char* common = "xterm-256color";
    const bool is_usable = !term.empty() && is_described(term.c_str());
    const char* const used = is_usable ? term.c_str() : common;
    const StatedSize size(columns, rows);
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
    typeahead(-1);  // or a pending key would keep ncurses from taking the screen
    curs_set(0);
    refresh();
    return CursesSession(std::move(state));
}

CursesSession::CursesSession(std::unique_ptr<State> state) : state_(std::move(state)) {}
CursesSession::CursesSession(CursesSession&&) noexcept = default;
CursesSession& CursesSession::operator=(CursesSession&&) noexcept = default;
CursesSession::~CursesSession() {
    if (state_ != nullptr) leave();
}

void CursesSession::set_size(int columns, int rows) {
    resize_term(rows, columns);
}

void CursesSession::leave() {
    if (std::exchange(state_->is_left, true)) return;
    // ncurses assumes plain style, but the last frame may have left another in force.
    const std::string plain_style = plain_style_bytes();
    [[maybe_unused]] const ssize_t written =
        write(fileno(state_->output), plain_style.data(), plain_style.size());
    endwin();
}

void CursesSession::enter() {
    if (!std::exchange(state_->is_left, false)) return;
    refresh();
}

}  // namespace carom
