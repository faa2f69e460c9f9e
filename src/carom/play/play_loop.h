#pragma once

#include <atomic>
#include <vector>

#include "carom/play/asciinema.h"
#include "carom/play/program.h"
#include "carom/play/worker.h"
#include "terminal/screen/pacing.h"
#include "terminal/screen/screen.h"

/// The loop of a game on a screen: time, picture, input, and again.
namespace carom {

/// s on a clock that does not go back.
double seconds_now();

MouseMode mouse_mode(const ScreenRequests& requests);

/// Where ticks are cheap, one thread does everything. Where they are not, and there is a second
/// core, a second thread computes them while the first draws, waits for the terminal and reads
/// input, so a key is answered at once however heavy the scene is.
///
/// While the second thread computes ticks, the program belongs to it: the first thread calls
/// nothing but Program::ends_tick(). When a key comes, the tick is cancelled, the key is handled
/// between two ticks, and the picture that shows its effect is drawn before the next tick is begun.
class PlayLoop {
  public:
    /// `asciinema`: the recording that is made, or none. All must outlive the loop.
    PlayLoop(Program& program, Screen& screen, const PacingOptions& pacing,
             AsciinemaRecording* asciinema);

    /// Returns when the program is over.
    void run();

  private:
    void turn();
    double advance(double passed, double now);
    void advance_beside(double passed, double now);
    void listen(bool owes_picture, std::vector<InputEvent>& events);
    bool is_heavy() const;
    bool may_tick_go_on();
    void look_for_input();
    std::vector<InputEvent> take_seen();
    Canvas draw(bool is_stalled);
    void show(const Canvas& canvas, double now);
    void wait(bool is_late, std::vector<InputEvent>& events);
    void handle(std::vector<InputEvent> events);

    Program& program_;
    Screen& screen_;
    Pacing pacing_;
    AsciinemaRecording* asciinema_;
    double frame_;  ///< s from one to the next
    double last_ = 0.0;
    bool input_came_ = true;   ///< and has not been shown
    double ticks_took_ = 0.0;  ///< when the game last ran, s

    // Input that is seen while a tick is computed in this thread.
    double next_look_ = 0.0;
    bool ends_tick_ = false;
    std::vector<InputEvent> seen_;

    // Between the two threads.
    bool is_beside_ = false;                ///< changes only while the worker rests
    std::atomic<bool> is_awaited_ = false;  ///< something came: no more ticks than must be
    std::atomic<bool> gives_up_ = false;    ///< nor the one that is being computed
    Worker worker_;
};

}  // namespace carom
