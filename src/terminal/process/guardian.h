#pragma once

#include <functional>
#include <string>

/// A parent that waits, so that the terminal is left clean however the player's process ends, even
/// by KILL.
namespace carom {

/// Runs `play` in a child process and returns the exit status for main to return.
///
/// The parent passes INT, QUIT, TERM and HUP on, stops and goes on with the child, and when the
/// child is killed by a signal it restores the terminal, prints "carom: <what happened>" and, if
/// not empty, `resume_hint` on standard error, and dies of the same signal. If the parent itself is
/// killed, the child ends in good order.
///
/// Without a terminal on standard input and output, or if no process can be made, `play` is simply
/// called. Call it early, before any thread is started and any output is buffered.
int run_guarded(const std::function<int()>& play, const std::string& resume_hint);

}  // namespace carom
