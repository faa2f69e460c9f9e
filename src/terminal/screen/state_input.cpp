#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "terminal/screen/state.h"

/// Input of an open screen: the terminal's answers, keys, the mouse, and signals.
namespace carom {
namespace {

constexpr double sequence_timeout = 0.25;  // s to wait for the rest of a sequence
constexpr double escape_step = 0.005;      // s that waiting for more than an ESC may cost a caller

bool is_control_key(const InputEvent& event, char32_t key) {
    return event.kind == InputEvent::Kind::key && event.key == key &&
           (event.modifiers & control) != 0;
}

}  // namespace

void Screen::State::take(const Answer& answer) {
    Capabilities before = capabilities;
    before.answers = capabilities.answers = true;
    if (answer.kind == Answer::Kind::status)
        queries.answered = std::min(queries.asked, queries.answered + 1);
    if (answer.kind == Answer::Kind::attributes) queries.is_done = true;
    if (answer.kind != Answer::Kind::status) queries.has_answered = true;
    if (!is_open) return;
    const int promised_before = modes.colors_promised();
    const bool had_overhang = modes.has_overhang();
    const std::string reply = modes.learn(answer);
    if (modes.colors_promised() != promised_before || modes.has_overhang() != had_overhang)
        choose_colors();
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

// Waits for one event of any kind; false if none came in that time.
bool Screen::State::wait_once(double seconds, int also) {
    using enum InputDecoder::Pending;
    if (!deferred.empty()) {
        take_signals();
        return true;
    }
    const InputDecoder::Pending pending = decoder.pending();
    const double escape_timeout = capabilities.ssh ? 0.050 : 0.025;
    const double limit = pending == escape ? escape_timeout : sequence_timeout;
    double timeout = seconds;
    if (pending != nothing) {
        const double left = std::max(escape_step, limit - idle);
        timeout = seconds < 0.0 ? left : std::min(left, std::max(seconds, escape_step));
        // `also` would cut the wait short, and `idle` could not count it. So it is not polled
        // while a sequence is pending, and the wait is short instead.
        if (also >= 0) timeout = std::min(timeout, escape_step);
        also = -1;
    }
    std::array<pollfd, 3> sources{{{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
                                   {.fd = signals.handle(), .events = POLLIN, .revents = 0},
                                   {.fd = also, .events = POLLIN, .revents = 0}}};
    const int milliseconds =
        timeout < 0.0 ? -1 : static_cast<int>(std::ceil(std::min(timeout, 1.0e5) * 1000.0));
    const int ready = poll(sources.data(), sources.size(), milliseconds);
    if (ready < 0) return errno == EINTR;  // the signal is in the pipe
    if (ready == 0) {
        idle += timeout;
        if (pending == nothing || idle < limit) return false;
        idle = 0.0;
        take(decoder.flush());
        return true;
    }
    idle = 0.0;
    if (sources[1].revents != 0) {
        take_signals();  // may read the terminal, so poll it again
    } else if (sources[0].revents != 0) {
        take_input();
    }
    return true;
}

}  // namespace carom
