#pragma once

#include <vector>

/// Delivers signals as bytes in a pipe, so that one poll() waits for them and for the terminal.
namespace carom {

/// INT, QUIT, TERM or HUP.
bool ends_the_game(int signal);

/// Catches WINCH, INT, QUIT, TERM, HUP, TSTP and CONT (INT, QUIT, TERM, HUP and TSTP only where
/// they were not ignored). Open it before ncurses starts, or ncurses takes some of them. At most
/// one exists at a time.
class SignalPipe {
  public:
    SignalPipe();
    SignalPipe(const SignalPipe&) = delete;
    SignalPipe& operator=(const SignalPipe&) = delete;
    /// Restores the previous handlers, except for a signal that has already requested the exit: it
    /// is ignored from now on, so that it cannot kill a program that is exiting cleanly. (HUP comes
    /// twice: from the terminal, and from the supervisor, which forwards it.)
    ~SignalPipe();

    /// Call it when the terminal is gone: HUP then counts as received, though it may arrive later.
    void expect_hangup();

    /// A file descriptor, readable when there is a signal to take.
    int handle() const;
    /// The signals since the last call, in order.
    std::vector<int> take();

    /// Stops this process the way Ctrl-Z does, and returns when it is continued. Pre: the terminal
    /// has been released. A process group without a shell to continue it is not stopped.
    void stop();
};

}  // namespace carom
