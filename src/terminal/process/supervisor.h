#pragma once

#include <functional>
#include <string>

/// A supervisor process: it restores the terminal however the player's process ends, even by KILL.
namespace carom {

/// Runs `play` in a child process and returns the exit status for main to return.
///
/// The parent forwards TSTP and whatever ends the game (screen/signals.h), and it stops and
/// continues with the child. When a signal kills the child, the parent restores the terminal,
/// prints "carom: <what happened>" and, if not empty, `resume_hint` on standard error, and dies of
/// that signal too. If the parent itself is killed, the child exits cleanly.
///
/// If standard input or output is not a terminal, or if fork() fails, `play` runs in this process.
/// Call it before any thread is started and before any output is buffered.
int run_supervised(const std::function<int()>& play, const std::string& resume_hint);

}  // namespace carom
