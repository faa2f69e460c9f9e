#pragma once

#include <termios.h>

#include <string_view>

/// Giving the terminal back when there is no time to do it well: out of a fatal signal's handler,
/// or from the parent of a process that is no more.
///
/// What it takes is kept ready in memory that a process shares with the children it makes later.
namespace carom {

/// Reserves the memory. Call it before a fork that is to share it; arming does it otherwise.
void prepare_restoration();

/// From now on the terminal needs to be given back: by sending `bytes` (at most 1,000 count), then
/// setting `modes`. `answers`: the terminal answers queries, so answers may still be on their way.
/// Arming again replaces what was there.
void arm_restoration(const termios& modes, std::string_view bytes, bool answers);

/// The terminal has been given back in good order.
void disarm_restoration();
bool is_restoration_armed();

/// Sends and sets what was armed, then disarms; does nothing if it is not armed. Uses write() and
/// tcsetattr() alone: safe in a signal handler.
void restore_terminal() noexcept;

/// The same, for the parent of a process that died: it has the time to take answers that are still
/// on their way off the terminal (for at most a second), so that they do not land in the shell.
void restore_after_death();

/// SEGV, ABRT, BUS, FPE and ILL give the terminal back and then do what they did before. The
/// handler has a stack of its own.
void catch_fatal_signals();

}  // namespace carom
