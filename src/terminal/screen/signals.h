#pragma once

#include <vector>

/// Signals, made into bytes that poll() can wait for beside the terminal.
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
    /// Does with signals what was done before; but a signal that has asked for the end once must
    /// not kill what is ending in good order, and is ignored from now on. (A terminal that hangs up
    /// tells the game and its guardian, which passes it on.)
    ~SignalPipe();

    /// The terminal is gone: HUP, which may come later, is as good as come.
    void expect_hangup();

    /// Readable when there is something to take.
    int handle() const;
    /// What has come since the last call, in order.
    std::vector<int> take();

    /// Stops this process the way Ctrl-Z does, and returns when it goes on. The terminal must have
    /// been given back. Where nobody could make it go on again, the system lets it go on at once.
    void stop();
};

}  // namespace carom
