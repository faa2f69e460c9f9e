#pragma once

#include <atomic>
#include <limits>

#include "carom/play/asciinema.h"
#include "carom/play/input_queue.h"
#include "carom/play/program.h"
#include "carom/play/worker.h"
#include "terminal/screen/pacing.h"
#include "terminal/screen/screen.h"

/// The main loop of a game on a screen: time, picture, input, repeat.
namespace carom {

/// Seconds on a monotonic clock.
double seconds_now();

MouseMode mouse_mode(const ScreenRequests& requests);

/// Where ticks are cheap, one thread does everything. Where they are expensive and there is a
/// second core, a second thread computes them while the first draws, waits for the terminal and
/// reads input, so that keys are answered at once however heavy the scene.
///
/// While the second thread computes ticks, it owns the program: the first thread calls nothing but
/// Program::cancels_tick(). When a key arrives, the tick is cancelled, the key is handled between
/// two ticks, and the picture that shows its effect is drawn before the next tick starts.
///
/// Input is handled for at most the time of a frame before the picture is drawn, whatever waits;
/// the end and a hang-up come first. Time stands still while input waits.
class PlayLoop {
  public:
    /// `asciinema`: the recording in progress, or null. All arguments must outlive the loop.
    PlayLoop(Program& program, Screen& screen, const PacingOptions& pacing,
             AsciinemaRecording* asciinema);

    /// Interrupts the program after so many seconds without a key or the mouse.
    void end_when_idle(double seconds) { most_idle_ = seconds; }
    /// Returns when the program has ended.
    void run();
    /// Whether it has ended because nobody pressed a key.
    bool was_idle() const { return was_idle_; }

  private:
    void turn();
    double advance(double passed, double now);
    void advance_in_background(double passed, double now);
    void listen(bool owes_picture);
    bool is_heavy() const;
    bool may_tick_go_on();
    void look_for_input();
    void queue(InputEvent event);
    Canvas draw(bool is_stalled);
    void show(const Canvas& canvas, double now);
    void wait(bool is_late);
    void handle_input();
    void handle(const InputEvent& event);
    void end_if_idle();

    Program& program_;
    Screen& screen_;
    Pacing pacing_;
    AsciinemaRecording* asciinema_;
    double frame_;  ///< s between frames
    double last_ = 0.0;
    bool input_came_ = true;   ///< input has arrived whose effect is not drawn yet
    double ticks_took_ = 0.0;  ///< the last time the game ran, s

    double most_idle_ = std::numeric_limits<double>::infinity();  ///< s
    double last_input_ = 0.0;  ///< the time of the last key or mouse event, s
    bool was_idle_ = false;

    InputQueue input_;
    // Input that arrives while a tick is computed in this thread.
    double next_look_ = 0.0;
    bool cancels_tick_ = false;

    // Shared between the two threads.
    bool is_in_background_ = false;  ///< changes only while the worker is idle
    /// Input has arrived: compute no more ticks than necessary.
    std::atomic<bool> has_input_ = false;
    std::atomic<bool> is_cancelled_ = false;  ///< cancel the tick that is being computed
    Worker worker_;
};

}  // namespace carom
