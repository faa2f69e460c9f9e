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
    /// name of the description; xterm-256color if it is empty or unknown. The error is a sentence
    /// with its remedy.
    static std::variant<CursesSession, std::string> start(const std::string& term);

    CursesSession(CursesSession&&) noexcept;
    CursesSession& operator=(CursesSession&&) noexcept;
    ~CursesSession();  ///< leaves the terminal

    /// The size according to the terminal's description and the environment.
    int columns() const;
    int rows() const;
    /// Sets the window size, which decides where the cursor goes on leaving. Pre: > 0.
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
