#pragma once

#include <memory>
#include <string>
#include <variant>

#include "terminal/screen/frame_differ.h"

/// The terminal in ncurses' hands: its description (terminfo), its modes, entering and leaving its
/// other screen. ncurses does not draw: its window stays blank, and FrameDiffer makes the frames.
namespace carom {

class CursesSession {
  public:
    /// Takes over the terminal on standard input and output: the other screen where there is one,
    /// the cursor hidden, keys one by one and unechoed, line feeds that only go down.
    /// `term`: the name of its description; xterm-256color where it is empty or not known. The
    /// error is a sentence with its remedy.
    static std::variant<CursesSession, std::string> start(const std::string& term);

    CursesSession(CursesSession&&) noexcept;
    CursesSession& operator=(CursesSession&&) noexcept;
    ~CursesSession();  ///< leaves

    /// The size that the terminal's description and the environment give.
    int columns() const;
    int rows() const;
    /// Where the cursor is put on leaving depends on the size. Pre: > 0.
    void set_size(int columns, int rows);

    /// Gives the terminal back for a while, and takes it again. Both write to it.
    void leave();
    void enter();

  private:
    struct State;
    explicit CursesSession(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace carom
