#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "terminal/canvas/canvas.h"
#include "terminal/input/capabilities.h"
#include "terminal/input/input.h"

/// The player's terminal: shows canvases, reads keys and the mouse. The only room that includes
/// ncurses. At most one screen is open at a time.
namespace carom {

/// What the mouse reports. `off` leaves the mouse to the terminal, so that text can be selected.
enum class MouseMode : std::uint8_t {
    off,
    drag,   ///< buttons, the wheel, and motion while a button is held
    motion  ///< and all other motion: for aiming
};

struct ScreenOptions {
    /// 0, 8, 16 or 256: at most this many; direct_colors: 24-bit colours, whatever TERM says. None:
    /// as many as the terminal has, subject to NO_COLOR.
    std::optional<int> colors;
    std::optional<bool> light_background;  ///< overrides the terminal's answer
    MouseMode mouse = MouseMode::drag;
    bool mouse_pixels = true;  ///< positions finer than a cell, where the terminal offers them
    bool key_release = true;   ///< ask for key releases, where the terminal has them
    bool queries = true;       ///< query the terminal's abilities
};

/// Why no screen could be opened, in a sentence with its remedy.
struct ScreenError {
    std::string message;
};

/// Whether a frame ends with a query that the terminal answers once it has drawn the frame
/// (pacing.h).
enum class FrameEnd : std::uint8_t { silent, asks };

class Screen {
  public:
    /// Takes over the terminal: alternate screen, cursor hidden, keys unbuffered, signals caught.
    /// Queries the terminal's abilities and waits up to a quarter of a second for the answers.
    /// Later answers still count: a resize event reports them.
    static std::variant<Screen, ScreenError> open(const ScreenOptions& options = {});

    Screen(Screen&&) noexcept;
    Screen& operator=(Screen&&) noexcept;
    ~Screen();  ///< closes

    /// The terminal's abilities as of the last wait(). A resize event reports a change.
    const Capabilities& capabilities() const;

    /// Makes the terminal show the canvas, in one write of the changed cells. Cells outside the
    /// window are not shown; where the canvas is smaller, the rest is blank. Returns the bytes
    /// written: 0 if nothing changed or the terminal is gone.
    std::size_t show(const Canvas& canvas, FrameEnd end = FrameEnd::silent);
    /// The bytes with which the last show() changed the picture, without synchronization and
    /// queries: whole characters and sequences; empty if show() returned 0. The first frame of each
    /// size clears the screen, so a recording can start there. Valid until the next show().
    std::string_view last_frame() const;
    /// The next show() sends every cell: for use after another program has written to the terminal.
    void redraw();

    /// Input and signals as events, in order. Returns as soon as there is one, at the latest after
    /// about `seconds` (0: at once; negative: no limit). Ctrl-C and Ctrl-\ are `end` events; Ctrl-Z
    /// suspends the program before this returns. `also`: a file descriptor that ends the wait when
    /// it becomes readable.
    std::vector<InputEvent> wait(double seconds, int also = -1);
    /// Sends the query that ends frames by itself. False: the terminal is gone.
    bool ask();
    /// The number of frames shown with FrameEnd::asks, and of calls of ask(), that have been
    /// answered since the start.
    unsigned frames_answered() const;

    MouseMode mouse() const;
    void set_mouse(MouseMode mode);
    void set_mouse_pixels(bool wanted);
    void bell();

    /// Restores the terminal. Afterwards all other calls do nothing.
    void close();

    struct State;  ///< state.h

  private:
    explicit Screen(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace carom
