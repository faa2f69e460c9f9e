#include "terminal/screen/screen.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>

#include "terminal/screen/environment.h"
#include "terminal/screen/restore.h"
#include "terminal/screen/state.h"
#include "terminal/screen/terminfo.h"

namespace carom {
namespace {

constexpr double answer_timeout = 0.25;  // s that open() waits for answers

// Programs that know nothing of COLORTERM pass it on, so it counts only together with 256 colours.
int colors_on_offer(const TerminalEnvironment& environment) {
    const int described = described_colors();
    const bool is_direct = described > 256 || (described == 256 && environment.has_direct_colors);
    return is_direct ? direct_colors : 256;
}

}  // namespace

std::variant<Screen, ScreenError> Screen::open(const ScreenOptions& options) {
    if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
        return ScreenError{fmt::format(
            "standard {} is not a terminal: play needs one (through ssh, add -t); to simulate "
            "without a screen, use carom run",
            isatty(STDIN_FILENO) == 0 ? "input" : "output")};
    }
    auto state = std::make_unique<State>();
    tcgetattr(STDOUT_FILENO, &state->modes_before);
    state->modes = TerminalModes(options);
    Capabilities& capabilities = state->capabilities;
    const TerminalEnvironment environment = read_terminal_environment();
    capabilities.utf8 = environment.is_utf8;
    capabilities.ssh = environment.is_ssh;
    capabilities.light_background = environment.is_light;
    if (environment.columns > 0) state->columns_unmeasured = environment.columns;
    if (environment.rows > 0) state->rows_unmeasured = environment.rows;
    state->read_size();
    auto started =
        CursesSession::start(environment.terminal, capabilities.columns, capabilities.rows);
    if (const auto* const error = std::get_if<std::string>(&started)) return ScreenError{*error};
    state->curses = std::get<CursesSession>(std::move(started));
    state->chosen_colors = options.colors;
    if (!options.colors && environment.wants_no_colors) state->chosen_colors = 0;
    state->described_most = colors_on_offer(environment);
    state->choose_colors();
    state->decoder = InputDecoder(capabilities.utf8, described_keys());
    catch_fatal_signals();
    state->measure();
    state->enter();
    if (options.queries && is_modern_emulator()) {
        state->send(capability_questions(environment.terminal.starts_with("screen")));
        constexpr int most_reads = 64;  // bounded, since somebody may be typing meanwhile
        for (int i = 0; i < most_reads && !state->queries.is_done; ++i) {
            if (!state->wait_once(answer_timeout)) break;
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
    state.frame = {};
    if (!state.is_open || state.is_gone) return 0;
    const std::string_view change = state.differ.paint(canvas);
    if (change.empty()) return 0;
    std::string bytes(state.modes.before_frame());
    bytes += change;
    bytes += state.modes.after_frame();
    if (end == FrameEnd::asks) bytes += status_question;
    if (!state.send(bytes)) {
        redraw();
        return 0;
    }
    if (end == FrameEnd::asks) ++state.queries.asked;
    state.frame = change;
    return bytes.size();
}

std::string_view Screen::last_frame() const {
    return state_->frame;
}

void Screen::redraw() {
    state_->differ.redraw();
}

std::vector<InputEvent> Screen::wait(double seconds, int also) {
    State& state = *state_;
    if (state.waiting.empty()) state.wait_once(seconds, also);
    if (state.is_gone && state.waiting.empty()) {
        state.waiting.push_back(event_of(InputEvent::Kind::hangup));
    }
    return std::exchange(state.waiting, {});
}

bool Screen::ask() {
    State& state = *state_;
    if (!state.is_open || state.is_gone || !state.send(status_question)) return false;
    ++state.queries.asked;
    return true;
}

unsigned Screen::frames_answered() const {
    return state_->queries.answered;
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
