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

/// The terminal that a person sits at: shows canvases, hears keys and the mouse. The only place
/// that includes ncurses. At most one is open at a time.
namespace carom {

/// What the mouse reports. `off` leaves it to the terminal, so that text can be selected.
enum class MouseMode : std::uint8_t {
    off,
    drag,   ///< buttons, the wheel, and motion while a button is held
    motion  ///< and all other motion: for aiming
};

struct ScreenOptions {
    /// 0, 8, 16 or 256: this many at most; direct_colors: 24-bit colours, whatever TERM says.
    /// None: as many as the terminal has, NO_COLOR honoured.
    std::optional<int> colors;
    std::optional<bool> light_background;  ///< overrides what the terminal says
    MouseMode mouse = MouseMode::drag;
    bool mouse_pixels = true;  ///< positions finer than a cell where the terminal offers them
    bool key_release = true;   ///< ask for the release of keys where the terminal has it
    bool queries = true;       ///< ask the terminal at all what it can do
};

/// Why there is no screen, in a sentence with its remedy.
struct ScreenError {
    std::string message;
};

/// Whether a frame ends with a question that the terminal answers once it has drawn it (pacing.h).
enum class FrameEnd : std::uint8_t { silent, asks };

class Screen {
  public:
    /// Takes the terminal over: alternate screen, cursor hidden, keys one by one, signals caught.
    /// Waits up to a quarter of a second for what the terminal says of itself; what comes later
    /// still counts, and is told by a resize event.
    static std::variant<Screen, ScreenError> open(const ScreenOptions& options = {});

    Screen(Screen&&) noexcept;
    Screen& operator=(Screen&&) noexcept;
    ~Screen();  ///< closes

    /// As of the last wait(). A resize event says that they have changed.
    const Capabilities& capabilities() const;

    /// Makes the terminal show the canvas with one write of no more than what changed. Cells
    /// outside the window are not shown; where the canvas is smaller, the rest is blank. Returns
    /// the bytes written: 0 where nothing changed and nothing is asked, or where the terminal is
    /// gone.
    std::size_t show(const Canvas& canvas, FrameEnd end = FrameEnd::silent);
    /// What the last show() sent to change the picture, without what stands around it: whole
    /// characters and whole sequences; empty where it returned 0. The first frame of all, and of
    /// each size, starts from nothing. Valid until the next show().
    std::string_view last_frame() const;
    /// The next show() sends everything: for a screen that something else has written over.
    void redraw();

    /// What the person did, in order. Returns as soon as there is anything, at the latest after
    /// about `seconds` (0: at once; forever where negative). Signals arrive as events as well;
    /// Ctrl-C and Ctrl-\ are `end`, and Ctrl-Z suspends the program before it returns.
    /// `also`: a file descriptor; where it is readable, that ends the wait too.
    std::vector<InputEvent> wait(double seconds, int also = -1);
    /// Frames shown with FrameEnd::asks that have been answered, since the start.
    unsigned frames_answered() const;

    MouseMode mouse() const;
    void set_mouse(MouseMode mode);
    void set_mouse_pixels(bool wanted);
    void bell();

    /// Gives the terminal back as it was. Everything else does nothing from then on.
    void close();

    struct State;  ///< state.h

  private:
    explicit Screen(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace carom
