#pragma once

#include <string>
#include <string_view>

#include "terminal/input/capabilities.h"
#include "terminal/input/input_answer.h"
#include "terminal/input/mouse.h"
#include "terminal/screen/screen.h"

/// The terminal modes that ncurses does not know: mouse, kitty keyboard protocol, bracketed paste,
/// synchronized output. Which are on depends on the player's options and on the terminal's answers.
/// Pure: it makes the bytes, the caller sends them.
namespace carom {

class TerminalModes {
  public:
    explicit TerminalModes(const ScreenOptions& options = {}) : options_(options) {}

    /// Turns on every mode that is wanted and offered, starting from all modes off; off() reverses
    /// it.
    std::string on() const;
    std::string off() const;

    /// Sets the mouse modes, whatever is in force.
    std::string mouse() const;
    MouseMode mouse_mode() const { return options_.mouse; }
    void set_mouse_mode(MouseMode mode) { options_.mouse = mode; }
    void set_mouse_pixels(bool wanted) { options_.mouse_pixels = wanted; }
    bool has_mouse_pixels() const;
    MouseUnit mouse_unit() const;

    /// Sent before and after a frame, so that the terminal shows it all at once.
    std::string_view before_frame() const;
    std::string_view after_frame() const;

    /// Takes the window's size in pixels and in cells; pixels are 0 where unknown. Returns whether
    /// the terminal should be queried instead (cell_question).
    bool measure(int pixels_wide, int pixels_high, int columns, int rows);
    /// Learns from an answer; returns the bytes to send in response.
    std::string learn(const Answer& answer);
    /// The most colours that an answer promised: 0, 256 or direct_colors.
    int colors_promised() const { return colors_promised_; }
    /// Whether glyphs reach over the edges of their cells: see TerminalTraits.
    bool has_overhang() const { return has_overhang_; }
    /// Copies the known abilities into `capabilities`.
    void tell(Capabilities& capabilities) const;

  private:
    bool learn_cell(int wide, int high);

    ScreenOptions options_;
    int cell_wide_ = 0;  // pixels; 0: not known
    int cell_high_ = 0;
    bool does_window_tell_pixels_ = false;
    bool has_pixel_reports_ = false;
    bool has_synchronized_output_ = false;
    bool has_key_protocol_ = false;
    std::optional<Rgb> background_;
    Mosaic mosaic_ = Mosaic::halves;
    int colors_promised_ = 0;
    bool has_overhang_ = false;
};

inline constexpr std::string_view status_question = "\033[5n";
inline constexpr std::string_view cell_question = "\033[16t";

}  // namespace carom
