#include "carom/play/play_loop.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

namespace carom {
namespace {

/// Share of the frame interval that ticks may take in the drawing thread; the rest is for drawing
/// and input.
constexpr double share_of_ticks = 0.75;
/// Ticks that take longer than this, s, are computed in the second thread, so that keys do not wait
/// for them.
constexpr double heavy = 0.002;
/// Share of the frame interval that ticks may take after input that does not cancel them, such as
/// mouse motion.
constexpr double awaited_share = 0.25;
/// The longest time that one turn of the loop may count (after a suspended process or on a busy
/// machine), s.
constexpr double longest_gap = 0.25;
/// The longest wait when there is nothing to do, s.
constexpr double longest_wait = 60.0;
/// The interval at which a long tick checks for input, s.
constexpr double look_interval = 0.002;

}  // namespace

double seconds_now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

MouseMode mouse_mode(const ScreenRequests& requests) {
    if (!requests.mouse) return MouseMode::off;
    return requests.motion ? MouseMode::motion : MouseMode::drag;
}

PlayLoop::PlayLoop(Program& program, Screen& screen, const PacingOptions& pacing,
                   AsciinemaRecording* asciinema)
    : program_(program),
      screen_(screen),
      pacing_(pacing),
      asciinema_(asciinema),
      frame_(1.0 / pacing.frames_per_second) {}

void PlayLoop::run() {
    program_.set_keep_going([this] { return may_tick_go_on(); });
    program_.set_capabilities(screen_.capabilities());
    last_ = seconds_now();
    last_input_ = last_;
    while (!program_.is_over())
        turn();
    program_.set_keep_going({});
}

void PlayLoop::turn() {
    const double now = seconds_now();
    // The game waits while the terminal does not respond.
    const bool is_stalled = pacing_.is_stalled(now);
    const double passed = is_stalled ? 0.0 : std::min(now - last_, longest_gap);
    last_ = now;
    cancels_tick_ = false;
    const bool is_running = input_.empty() && program_.seconds_to_change(now) <= 0.0;
    const bool is_in_background = is_running && is_heavy();
    // When ticks take longer than a frame, the effect of a key is drawn before the next tick.
    const bool is_answer = is_running && !is_in_background && input_came_ && ticks_took_ > frame_;
    if (is_answer) ticks_took_ = 0.0;
    if (input_.empty() && !is_in_background && !is_answer) {
        const double took = advance(passed, now);
        if (is_running) ticks_took_ = took;
    }

    const double drawing = seconds_now();
    const bool is_due = program_.needs_draw() || is_stalled;
    if (is_due && pacing_.wants_query() && screen_.ask()) pacing_.asked(drawing);
    const bool is_late = is_due && !pacing_.may_draw(drawing, input_came_);
    std::optional<Canvas> canvas;
    if (is_due && !is_late) canvas = draw(is_stalled);
    const ScreenRequests requests = program_.screen_requests();
    if (program_.take_bell()) screen_.bell();
    if (is_in_background) advance_in_background(passed, now);
    if (canvas) show(*canvas, drawing);
    screen_.set_mouse(mouse_mode(requests));
    if (is_in_background) listen(is_late && input_came_);

    wait(is_late);
    handle_input();
    end_if_idle();
}

bool PlayLoop::is_heavy() const {
    static const bool has_second_core = std::thread::hardware_concurrency() > 1;
    return has_second_core && worker_.is_there() && program_.is_playing() && ticks_took_ > heavy;
}

double PlayLoop::advance(double passed, double now) {
    const double start = seconds_now();
    const double due = now + share_of_ticks * frame_;
    program_.advance(passed, now, [due] { return seconds_now() < due; });
    return seconds_now() - start;
}

void PlayLoop::advance_in_background(double passed, double now) {
    is_in_background_ = true;
    has_input_ = false;
    is_cancelled_ = false;
    worker_.start([this, passed, now] {
        const double start = seconds_now();
        program_.advance(passed, now, [this, now] {
            return seconds_now() < now + frame_ * (has_input_ ? awaited_share : 1.0);
        });
        const double took = seconds_now() - start;
        // The time of a cancelled tick says nothing about the next.
        ticks_took_ = is_cancelled_ ? std::max(ticks_took_, took) : took;
    });
}

// Waits until the second thread has finished its ticks. `owes_picture`: a picture that shows the
// effect of a key is waiting for the terminal; once it may be drawn, the tick is cancelled for it.
void PlayLoop::listen(bool owes_picture) {
    while (!worker_.is_done() && !is_cancelled_) {
        double seconds = longest_wait;
        if (owes_picture) seconds = pacing_.seconds_to_frame(seconds_now(), true);
        for (const InputEvent& event : screen_.wait(seconds, worker_.handle())) {
            has_input_ = true;
            if (program_.cancels_tick(event)) is_cancelled_ = true;
            queue(event);
        }
        const double now = seconds_now();
        pacing_.answered(screen_.frames_answered(), now);
        if (owes_picture && pacing_.may_draw(now, true)) is_cancelled_ = true;
    }
    worker_.finish();
    is_in_background_ = false;
}

bool PlayLoop::may_tick_go_on() {
    if (is_in_background_) return !is_cancelled_;
    look_for_input();
    return !cancels_tick_;
}

void PlayLoop::look_for_input() {
    const double now = seconds_now();
    if (now < next_look_) return;
    next_look_ = now + look_interval;
    for (const InputEvent& event : screen_.wait(0.0)) {
        cancels_tick_ = cancels_tick_ || program_.cancels_tick(event);
        queue(event);
    }
}

void PlayLoop::queue(InputEvent event) {
    event.after = seconds_now() - last_;
    input_.push(event);
}

Canvas PlayLoop::draw(bool is_stalled) {
    if (is_stalled) screen_.redraw();  // so that the terminal has something to answer
    Canvas canvas(screen_.capabilities().columns, screen_.capabilities().rows);
    program_.draw(canvas);
    input_came_ = false;
    return canvas;
}

void PlayLoop::show(const Canvas& canvas, double now) {
    const std::size_t bytes = screen_.show(canvas, FrameEnd::asks);
    if (bytes == 0) return;
    pacing_.drawn(now, bytes);
    if (asciinema_) asciinema_->add(now, canvas.columns(), canvas.rows(), screen_.last_frame());
}

// Waits for input, or for the time of the next frame.
void PlayLoop::wait(bool is_late) {
    const double now = seconds_now();
    double seconds = program_.seconds_to_change(now);
    if (seconds < frame_ || is_late) {
        // Ticks that use up all the time leave none to wait in.
        const double least = ticks_took_ > heavy && !is_late ? 0.0 : 0.001;
        seconds = std::max(pacing_.seconds_to_frame(now, input_came_), least);
    }
    if (!input_.empty()) seconds = 0.0;
    seconds = std::min(seconds, std::max(0.0, last_input_ + most_idle_ - now));
    for (const InputEvent& event : screen_.wait(std::min(seconds, longest_wait)))
        queue(event);
    pacing_.answered(screen_.frames_answered(), seconds_now());
}

// Handling an event may take as long as a tick, and more may arrive meanwhile.
void PlayLoop::handle_input() {
    const double end = seconds_now() + frame_;
    while (!input_.empty() && !program_.is_over()) {
        handle(input_.pop());
        look_for_input();
        if (seconds_now() >= end) break;
    }
    if (!input_.empty()) return;
    if (const std::size_t dropped = input_.take_dropped()) program_.tell_dropped_input(dropped);
}

void PlayLoop::handle(const InputEvent& event) {
    using enum InputEvent::Kind;
    input_came_ = true;
    cancels_tick_ = false;
    if (event.kind == key || event.kind == mouse) last_input_ = seconds_now();
    if (event.kind == InputEvent::Kind::resize)
        program_.set_capabilities(screen_.capabilities());
    else
        program_.handle(event, seconds_now());
}

void PlayLoop::end_if_idle() {
    if (program_.is_over() || seconds_now() - last_input_ < most_idle_) return;
    was_idle_ = true;
    InputEvent end;
    end.kind = InputEvent::Kind::end;
    program_.handle(end, seconds_now());
}

}  // namespace carom
