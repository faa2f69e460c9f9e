#pragma once

#include <vector>

/// Signals as bytes in a pipe, so that poll() can wait for them and for the terminal at once.
namespace carom {

/// INT, QUIT, TERM or HUP.
bool ends_the_game(int signal);

/// Catches WINCH, INT, QUIT, TERM, HUP, TSTP and CONT (not INT, QUIT, TERM, HUP or TSTP where they
/// were ignored). Open it before ncurses starts, or ncurses takes some of them. One at a time.
class SignalPipe {
  public:
    SignalPipe();
    SignalPipe(const SignalPipe&) = delete;
    SignalPipe& operator=(const SignalPipe&) = delete;
    /// Restores the previous handlers, except for a signal that has already asked for the end: it
    /// is ignored from now on, so that it cannot kill a program that is ending in good order. (HUP
    /// comes twice: from the terminal, and from the supervisor, which passes it on.)
    ~SignalPipe();

    /// The terminal is gone: from now on HUP counts as received, though it may come later.
    void expect_hangup();

    /// Readable when there is something to take.
    int handle() const;
    /// The signals since the last call, in order.
    std::vector<int> take();

    /// Stops this process the way Ctrl-Z does, and returns when it is continued. Pre: the terminal
    /// has been given back. A process group without a shell to continue it is not stopped.
    void stop();
};

}  // namespace carom
