#pragma once

#include <termios.h>

#include <string_view>

/// Restores the terminal when carom cannot exit cleanly: in the handler of a fatal signal, or in
/// the supervisor of a process that was killed.
///
/// The required bytes and modes are kept ready in memory that a process shares with the children it
/// forks later.
namespace carom {

/// Reserves the memory. Call it before a fork that should share it; otherwise arming reserves it.
void prepare_restoration();

/// From now on, restoring the terminal means sending `bytes` (the first 1,000 of them) and then
/// setting `modes`. `answers`: the terminal answers queries, so answers may still be on their way.
/// Arming again replaces bytes and modes.
void arm_restoration(const termios& modes, std::string_view bytes, bool answers);

/// Call it after the terminal has been restored normally.
void disarm_restoration();
bool is_restoration_armed();

/// Sends and sets what was armed, then disarms; does nothing if nothing is armed. Uses write() and
/// tcsetattr() only: safe in a signal handler.
void restore_terminal() noexcept;

/// Restores the terminal in the supervisor of a process that died. Unlike a signal handler it can
/// wait: it first reads answers that are still on their way, until none has come for a second, so
/// that they do not reach the shell.
void restore_after_death();

/// Makes SEGV, ABRT, BUS, FPE, ILL, TRAP and SYS restore the terminal before they take their
/// previous effect. The handler runs on a stack of its own, so that an overflow of the stack is
/// handled too.
void catch_fatal_signals();

}  // namespace carom
