#include "terminal/screen.h"

#include <fmt/format.h>
#include <langinfo.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include <utility>

#include "terminal/input_decoder.h"
#include "terminal/restore.h"
#include "terminal/screen_curses.h"
#include "terminal/screen_modes.h"
#include "terminal/screen_signals.h"
#include "terminal/screen_terminfo.h"

namespace carom {
namespace {

constexpr double answer_patience = 0.25;    // s that open() waits for answers
constexpr double sequence_patience = 0.25;  // s until the rest of a sequence is given up
constexpr double escape_step = 0.005;       // s that waiting for more than an ESC may cost a caller
std::string_view environment(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

// Sets the locale's characters. A locale that is named and not installed, as often behind SSH,
// still says what the terminal understands.
bool is_utf8_locale() {
    if (std::setlocale(LC_CTYPE, "") == nullptr) {
        const std::string_view named = !environment("LC_ALL").empty()     ? environment("LC_ALL")
                                       : !environment("LC_CTYPE").empty() ? environment("LC_CTYPE")
                                                                          : environment("LANG");
        const bool is_utf8 = named.ends_with("UTF-8") || named.ends_with("utf8");
        if (is_utf8) std::setlocale(LC_CTYPE, "C.UTF-8");
    }
    return std::string_view(nl_langinfo(CODESET)) == "UTF-8";
}

bool is_control_key(const InputEvent& event, char32_t key) {
    return event.kind == InputEvent::Kind::key && event.key == key &&
           (event.modifiers & control) != 0;
}

InputEvent event_of(InputEvent::Kind kind) {
    InputEvent event;
    event.kind = kind;
    return event;
}

}  // namespace

struct Screen::State {
    ScreenSignals signals;  // before ncurses: it leaves alone what is caught already
    std::optional<Curses> curses;
    ScreenModes modes;
    InputDecoder decoder;
    Capabilities capabilities;
    termios modes_before{};
    std::vector<InputEvent> waiting;  // for the next wait()
    std::vector<int> deferred;        // signals that came while something was being sent
    double idle = 0.0;                // s waited in vain for the rest of what has begun
    unsigned asked = 0;               // for the terminal's status
    unsigned answered = 0;            // at most `asked`
    bool does_answer_questions = false;
    bool has_answered_all = false;  // the sentinel came back
    bool is_open = false;
    bool is_gone = false;

    void enter();
    void leave();
    void suspend();
    void repair();
    void arm() const;
    bool send(std::string_view bytes);
    void measure();
    void set_mouse();
    void take(const DecodedInput& input);
    void take(const Answer& answer);
    void take(const InputEvent& event);
    void take_signal(int signal);
    void take_signals();
    void take_input();
    bool wait_once(double seconds);
    void hang_up();
};

// Sends all, if it takes ever so long; gives up when the terminal is gone or carom is to end.
bool Screen::State::send(std::string_view bytes) {
    while (!bytes.empty() && !is_gone) {
        const ssize_t written = write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            hang_up();
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, written)));
        if (bytes.empty()) break;
        // A signal came. It is not dealt with here: that might write into the middle of these.
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

// Keeps ready what restore.h may need, as things stand.
void Screen::State::arm() const {
    arm_restoration(modes_before, modes.off() + farewell_bytes(capabilities.rows),
                    capabilities.answers);
}

void Screen::State::measure() {
    winsize size{};
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    const bool has_size = size.ws_col > 0 && size.ws_row > 0;
    capabilities.columns = has_size ? size.ws_col : std::max(1, curses->columns());
    capabilities.rows = has_size ? size.ws_row : std::max(1, curses->rows());
    const bool is_to_ask = modes.measure(size.ws_xpixel, size.ws_ypixel, size.ws_col, size.ws_row);
    if (is_to_ask && is_open && does_answer_questions) send(cell_question);
    modes.tell(capabilities);
    curses->set_size(capabilities.columns, capabilities.rows);
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
    pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
    if (poll(&output, 1, 200) == 0) tcflush(STDOUT_FILENO, TCOFLUSH);  // stuck: drop what is old
    std::string bytes = modes.off();
    if (capabilities.answers) {
        bytes += status_question;
        ++asked;
    }
    send(bytes);
    // Answers that are still on their way must not land in the shell.
    while (capabilities.answers && asked != answered && !is_gone) {
        if (!wait_once(1.0)) break;
    }
    if (capabilities.answers) --asked;
    answered = asked;
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

// Stopped by STOP and gone on: who knows what has been done to the terminal meanwhile.
void Screen::State::repair() {
    send(modes.off());
    curses->leave();
    curses->enter();
    measure();
    enter();
    waiting.push_back(event_of(InputEvent::Kind::resize));
}

void Screen::State::take(const Answer& answer) {
    Capabilities before = capabilities;
    before.answers = capabilities.answers = true;
    if (answer.kind == Answer::Kind::status) answered = std::min(asked, answered + 1);
    if (answer.kind == Answer::Kind::attributes) has_answered_all = true;
    if (answer.kind != Answer::Kind::status) does_answer_questions = true;
    if (!is_open) return;
    const std::string reply = modes.learn(answer);
    modes.tell(capabilities);
    decoder.set_mouse_unit(modes.mouse_unit());
    arm();
    send(reply);
    if (capabilities != before) waiting.push_back(event_of(InputEvent::Kind::resize));
}

void Screen::State::take(const InputEvent& event) {
    const bool is_pressed = event.action != InputEvent::Action::release;
    if (is_control_key(event, U'c') || is_control_key(event, U'\\')) {
        if (is_pressed) waiting.push_back(event_of(InputEvent::Kind::end));
    } else if (is_control_key(event, U'z')) {
        if (is_pressed && is_open) suspend();
    } else {
        waiting.push_back(event);
    }
}

void Screen::State::take(const DecodedInput& input) {
    for (const Answer& answer : input.answers) {
        take(answer);
    }
    for (const InputEvent& event : input.events) {
        take(event);
    }
}

void Screen::State::take_signal(int signal) {
    switch (signal) {
        case SIGWINCH:
            measure();
            set_mouse();
            waiting.push_back(event_of(InputEvent::Kind::resize));
            return;
        case SIGHUP:
            return waiting.push_back(event_of(InputEvent::Kind::hangup));
        case SIGTSTP:
            return is_open ? suspend() : void();
        case SIGCONT:
            return is_open ? repair() : void();
        default:
            return waiting.push_back(event_of(InputEvent::Kind::end));
    }
}

void Screen::State::take_signals() {
    std::vector<int> taken = std::exchange(deferred, {});
    std::ranges::copy(signals.take(), std::back_inserter(taken));
    for (const int signal : taken) {
        take_signal(signal);
    }
}

void Screen::State::take_input() {
    std::array<char, 4096> bytes;
    const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count > 0) return take(decoder.feed({bytes.data(), static_cast<std::size_t>(count)}));
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    hang_up();
}

// Waits for one thing of whatever kind; false when nothing came in that time.
bool Screen::State::wait_once(double seconds) {
    using enum InputDecoder::Pending;
    if (!deferred.empty()) {
        take_signals();
        return true;
    }
    const InputDecoder::Pending pending = decoder.pending();
    const double escape_patience = capabilities.ssh ? 0.050 : 0.025;
    const double patience = pending == escape ? escape_patience : sequence_patience;
    double timeout = seconds;
    if (pending != nothing) {
        const double left = std::max(escape_step, patience - idle);
        timeout = seconds < 0.0 ? left : std::min(left, std::max(seconds, escape_step));
    }
    std::array<pollfd, 2> sources{{{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
                                   {.fd = signals.handle(), .events = POLLIN, .revents = 0}}};
    const int milliseconds =
        timeout < 0.0 ? -1 : static_cast<int>(std::ceil(std::min(timeout, 1.0e5) * 1000.0));
    const int ready = poll(sources.data(), sources.size(), milliseconds);
    if (ready < 0) return errno == EINTR;  // the signal is in the pipe
    if (ready == 0) {
        idle += timeout;
        if (pending == nothing || idle < patience) return false;
        idle = 0.0;
        take(decoder.flush());
        return true;
    }
    idle = 0.0;
    if (sources[1].revents != 0) {
        take_signals();  // which may read the terminal, so that it is to be asked afresh
    } else {
        take_input();
    }
    return true;
}

std::variant<Screen, ScreenError> Screen::open(const ScreenOptions& options) {
    if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
        return ScreenError{fmt::format(
            "standard {} is not a terminal: play needs one (through ssh, add -t); to simulate "
            "without a screen, use carom run",
            isatty(STDIN_FILENO) == 0 ? "input" : "output")};
    }
    auto state = std::make_unique<State>();
    tcgetattr(STDOUT_FILENO, &state->modes_before);
    state->modes = ScreenModes(options);
    Capabilities& capabilities = state->capabilities;
    capabilities.utf8 = is_utf8_locale();
    capabilities.ssh = !environment("SSH_CONNECTION").empty() || !environment("SSH_TTY").empty();
    capabilities.light_background = light_background_from(environment("COLORFGBG")).value_or(false);
    const int most_colors = options.colors.value_or(environment("NO_COLOR").empty() ? 256 : 0);
    auto started = Curses::start(std::getenv("TERM"), most_colors, capabilities.utf8);
    if (const auto* const error = std::get_if<std::string>(&started)) return ScreenError{*error};
    state->curses = std::get<Curses>(std::move(started));
    capabilities.colors = std::min(256, state->curses->colors());
    state->decoder = InputDecoder(capabilities.utf8, described_keys());
    catch_fatal_signals();
    state->measure();
    state->enter();
    if (options.queries && state->curses->is_modern()) {
        state->send(capability_questions());
        constexpr int most_reads = 64;  // somebody may be typing meanwhile
        for (int i = 0; i < most_reads && !state->has_answered_all; ++i) {
            if (!state->wait_once(answer_patience)) break;
        }
        std::erase_if(state->waiting, [](const InputEvent& event) {
            return event.kind == InputEvent::Kind::resize;
        });
    }
    return Screen(std::move(state));
}

Screen::Screen(std::unique_ptr<State> state) : state_(std::move(state)) {}
Screen::Screen(Screen&&) noexcept = default;
Screen& Screen::operator=(Screen&& other) noexcept {
    close();
    state_ = std::move(other.state_);
    return *this;
}
Screen::~Screen() {
    close();
}

const Capabilities& Screen::capabilities() const {
    return state_->capabilities;
}

std::size_t Screen::show(const Canvas& canvas, FrameEnd end) {
    State& state = *state_;
    if (!state.is_open || state.is_gone) return 0;
    const std::string_view change = state.curses->paint(canvas);
    if (change.empty()) return 0;
    std::string bytes(state.modes.before_frame());
    bytes += change;
    bytes += state.modes.after_frame();
    if (end == FrameEnd::asks) bytes += status_question;
    if (!state.send(bytes)) {
        redraw();
        return 0;
    }
    if (end == FrameEnd::asks) ++state.asked;
    return bytes.size();
}

void Screen::redraw() {
    state_->curses->redraw();
}

std::vector<InputEvent> Screen::wait(double seconds) {
    State& state = *state_;
    if (state.waiting.empty()) state.wait_once(seconds);
    if (state.is_gone && state.waiting.empty()) {
        state.waiting.push_back(event_of(InputEvent::Kind::hangup));
    }
    return std::exchange(state.waiting, {});
}

unsigned Screen::frames_answered() const {
    return state_->answered;
}

MouseMode Screen::mouse() const {
    return state_->modes.mouse_mode();
}

void Screen::set_mouse(MouseMode mode) {
    if (mode == mouse()) return;
    state_->modes.set_mouse_mode(mode);
    state_->set_mouse();
}

void Screen::set_mouse_pixels(bool wanted) {
    state_->modes.set_mouse_pixels(wanted);
    state_->set_mouse();
}

void Screen::bell() {
    if (state_->is_open) state_->send("\a");
}

void Screen::close() {
    if (state_ != nullptr) state_->leave();
}

}  // namespace carom
