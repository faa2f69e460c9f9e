#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "terminal/canvas/canvas.h"

/// ncurses, behind a door: it owns the terminal's modes, its description and the difference between
/// what it shows and what it should show. Only the files screen_*.cpp include it.
///
/// ncurses writes into memory, not to the terminal: so a frame is one write of whatever size, more
/// can be put before and behind it, and a write that fails is noticed. What it does at the start,
/// and when the terminal is left and entered again, goes straight to the terminal.
namespace carom {

class Curses {
  public:
    /// Takes the terminal on standard input and output over. `term`: the name of its description;
    /// empty: a common one. `most_colors`: 0 for none. `utf8`: what the locale says. The error is
    /// a sentence.
    static std::variant<Curses, std::string> start(const std::string& term, int most_colors,
                                                   bool utf8);

    Curses(Curses&&) noexcept;
    Curses& operator=(Curses&&) noexcept;
    ~Curses();  ///< leaves

    /// Colours in use: 0, 8, 16, 256, or more where numbers stand for red, green and blue.
    int colors() const;
    /// Whether this is an emulator of today, which may be asked questions.
    bool is_modern() const;
    /// The size that the terminal's description and the environment give.
    int columns() const;
    int rows() const;

    /// From the next paint on, the window has this size, and everything is sent. Pre: > 0.
    void set_size(int columns, int rows);
    void redraw();
    /// What to send so that the terminal shows `canvas`; valid until the next call.
    std::string_view paint(const Canvas& canvas);

    /// Gives the terminal back for a while, and takes it again. Both write to it.
    void leave();
    void enter();

    struct State;

  private:
    explicit Curses(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace carom
