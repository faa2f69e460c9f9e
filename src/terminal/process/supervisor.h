#pragma once

#include <functional>
#include <string>

/// A parent process that supervises the player's process, so that the terminal is left clean
/// however that process ends, even by KILL.
namespace carom {

/// Runs `play` in a child process and returns the exit status for main to return.
///
/// The parent passes INT, QUIT, TERM, HUP and TSTP on, and it stops and continues with the child.
/// When a signal kills the child, the parent restores the terminal, prints "carom: <what happened>"
/// and, if not empty, `resume_hint` on standard error, and dies of that signal too. If the parent
/// itself is killed, the child ends in good order.
///
/// Without a terminal on standard input and output, or if fork() fails, `play` runs in this
/// process. Call it before any thread is started and before any output is buffered.
int run_supervised(const std::function<int()>& play, const std::string& resume_hint);

}  // namespace carom
