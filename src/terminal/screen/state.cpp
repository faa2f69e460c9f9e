#include "terminal/screen/state.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>
#include <string>
#include <utility>

#include "terminal/screen/restore.h"
#include "terminal/screen/terminfo.h"

namespace carom {
namespace {

// No screen shows more cells. A window that claims more gets a picture of this size in its corner.
constexpr int most_columns = 1000;
constexpr int most_rows = 500;

}  // namespace

InputEvent event_of(InputEvent::Kind kind) {
    InputEvent event;
    event.kind = kind;
    return event;
}

// Sends all bytes, however long that takes. Gives up when the terminal is gone or carom must exit.
bool Screen::State::send(std::string_view bytes) {
    while (!bytes.empty() && !is_gone) {
        const ssize_t written = write(terminal.handle(), bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR && errno != EAGAIN) {
            hang_up();
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, written)));
        if (bytes.empty()) break;
        // The terminal takes no more for now, or a signal has interrupted the write. A signal is in
        // its pipe, also one that came before this wait.
        std::array<pollfd, 2> sources{{{.fd = terminal.handle(), .events = POLLOUT, .revents = 0},
                                       {.fd = signals.handle(), .events = POLLIN, .revents = 0}}};
        poll(sources.data(), sources.size(), -1);
        // Handling signals now could write into the middle of `bytes`.
        std::ranges::copy(signals.take(), std::back_inserter(deferred));
        if (std::ranges::any_of(deferred, ends_the_game)) return false;
    }
    return !is_gone;
}

void Screen::State::hang_up() {
    if (std::exchange(is_gone, true)) return;
    signals.expect_hangup();
    waiting.push_back(event_of(InputEvent::Kind::hangup));
}

// Updates the bytes and modes with which restore.h would restore the terminal.
void Screen::State::arm() const {
    arm_restoration(modes_before, modes.off() + farewell_bytes(capabilities.rows),
                    capabilities.answers);
}

winsize Screen::State::read_size() {
    winsize size{};
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    const bool has_size = size.ws_col > 0 && size.ws_row > 0;
    const int columns = has_size ? size.ws_col : columns_unmeasured;
    const int rows = has_size ? size.ws_row : rows_unmeasured;
    capabilities.columns = std::clamp(columns, 1, most_columns);
    capabilities.rows = std::clamp(rows, 1, most_rows);
    return size;
}

void Screen::State::measure() {
    const winsize size = read_size();
    const bool is_to_ask = modes.measure(size.ws_xpixel, size.ws_ypixel, size.ws_col, size.ws_row);
    if (is_to_ask && is_open && queries.has_answered) send(cell_question);
    modes.tell(capabilities);
    curses->set_size(capabilities.columns, capabilities.rows);
    differ.set_size(capabilities.columns, capabilities.rows);
}

// Uses as many colours as the terminal has, by its description, the environment and its answers, or
// those that the player chose. The frame after a change sends every cell.
void Screen::State::choose_colors() {
    const int promised = modes.colors_promised();
    TerminalDialect dialect = described_dialect(
        chosen_colors.value_or(std::max(described_most, promised)), capabilities.utf8, promised);
    // Over a network the bytes are better spent on frames.
    dialect.has_overhang = modes.has_overhang() && !capabilities.ssh;
    capabilities.colors = std::min(256, dialect.colors);
    capabilities.direct_color = dialect.colors == direct_colors;
    differ = FrameDiffer(dialect);
    differ.set_size(capabilities.columns, capabilities.rows);
}

void Screen::State::set_mouse() {
    decoder.set_mouse_unit(modes.mouse_unit());
    modes.tell(capabilities);
    if (is_open) send(modes.mouse());
}

void Screen::State::enter() {
    is_open = true;
    arm();
    send(modes.on());
    decoder.set_mouse_unit(modes.mouse_unit());
}

void Screen::State::leave() {
    if (!std::exchange(is_open, false)) return;
    // A signal would interrupt a write, of ncurses too, and leave modes on: the supervisor passes
    // on what a process group has received already.
    const SignalPipe::Delay delay;
    pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
    if (poll(&output, 1, 200) == 0) tcflush(STDOUT_FILENO, TCOFLUSH);  // stuck: drop old output
    std::string bytes = modes.off();
    if (capabilities.answers) {
        bytes += status_question;
        ++queries.asked;
    }
    send(bytes);
    // Answers that are still on their way must not reach the shell.
    while (capabilities.answers && queries.asked != queries.answered && !is_gone) {
        if (!wait_once(1.0)) break;
    }
    if (capabilities.answers) --queries.asked;
    queries.answered = queries.asked;
    curses->leave();
    disarm_restoration();
    tcflush(STDIN_FILENO, TCIFLUSH);
}

void Screen::State::suspend() {
    leave();
    signals.stop();
    curses->enter();
    measure();
    enter();
    for (const int signal : signals.take()) {
        if (ends_the_game(signal)) take_signal(signal);
    }
    waiting.push_back(event_of(InputEvent::Kind::resize));
}

// After STOP and CONT: other programs may have changed the terminal meanwhile, so set it up anew.
void Screen::State::repair() {
    send(modes.off());
    curses->leave();
    curses->enter();
    measure();
    enter();
    waiting.push_back(event_of(InputEvent::Kind::resize));
}

}  // namespace carom
