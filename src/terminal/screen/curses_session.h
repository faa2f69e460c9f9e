#pragma once

#include <memory>
#include <string>
#include <variant>

#include "terminal/screen/frame_differ.h"

/// ncurses' part in the front end: it knows the terminal's description (terminfo), sets its modes,
/// and enters and leaves the alternate screen. ncurses does not draw: its window stays blank, and
/// FrameDiffer makes the frames.
namespace carom {

class CursesSession {
  public:
    /// Takes over the terminal on standard input and output: alternate screen where there is one,
    /// cursor hidden, keys unbuffered and without echo, line feeds that only move down. `term`: the
    /// name of the description; xterm-256color if it is empty or unknown. The window's size must be
    /// right, since the scrolling region is set with it. Pre: 0 < columns, rows <= 1000. The error
    /// is a sentence with its remedy.
    static std::variant<CursesSession, std::string> start(const std::string& term, int columns,
                                                          int rows);

    CursesSession(CursesSession&&) noexcept;
    CursesSession& operator=(CursesSession&&) noexcept;
    ~CursesSession();  ///< leaves the terminal

    /// Sets the window's size, which decides where the cursor goes on leaving. Pre: > 0.
    void set_size(int columns, int rows);

    /// Releases the terminal for a while, and takes it again. Both write to it.
    void leave();
    void enter();

  private:
    struct State;
    explicit CursesSession(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace carom
