#pragma once

#include <signal.h>

#include <vector>

/// Delivers signals as bytes in a pipe, so that one poll() waits for them and for the terminal.
namespace carom {

/// Whether the signal requests the end of a game: INT, QUIT, TERM and HUP, and all others that
/// would end a process and do not report a fault in it: USR1, USR2, ALRM, VTALRM, PROF, XCPU, POLL,
/// PWR, STKFLT, and the real-time signals.
bool ends_the_game(int signal);
/// All of these, ascending.
std::vector<int> signals_that_end_the_game();

/// Catches WINCH, TSTP and CONT, and whatever ends the game. INT, QUIT, TERM, HUP and TSTP stay
/// ignored where they were ignored; of the less common signals it takes only those that would end
/// the process, since a profiler may use one. Open it before ncurses starts, or ncurses takes some
/// of them. At most one exists at a time.
class SignalPipe {
  public:
    /// While it exists, the signals that a pipe catches wait. Pre: there is a pipe.
    class Delay {
      public:
        Delay();
        ~Delay();
        Delay(const Delay&) = delete;
        Delay& operator=(const Delay&) = delete;

      private:
        sigset_t before_{};
    };

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
