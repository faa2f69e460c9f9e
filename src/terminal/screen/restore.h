#pragma once

#include <termios.h>

#include <string_view>

/// Restores the terminal where an orderly exit is impossible: in the handler of a fatal signal, or
/// in the supervisor of a process that was killed.
///
/// The bytes and modes that this takes are kept ready in memory which a process shares with the
/// children that it forks later.
namespace carom {

/// Reserves the memory. Call it before a fork that is to share it; arming does it otherwise.
void prepare_restoration();

/// From now on the terminal is to be restored by sending `bytes` (the first 1,000 of them) and then
/// setting `modes`. `answers`: the terminal answers queries, so answers may still be on their way.
/// Arming again replaces bytes and modes.
void arm_restoration(const termios& modes, std::string_view bytes, bool answers);

/// The terminal has been given back in good order.
void disarm_restoration();
bool is_restoration_armed();

/// Sends and sets what was armed, then disarms; does nothing if it is not armed. Uses write() and
/// tcsetattr() alone: safe in a signal handler.
void restore_terminal() noexcept;

/// Restores the terminal in the supervisor of a process that died. Unlike a signal handler it can
/// wait: it first reads the answers that are still on their way (for at most a second without any),
/// so that they do not land in the shell.
void restore_after_death();

/// Makes SEGV, ABRT, BUS, FPE and ILL restore the terminal before they take their previous effect.
/// The handler runs on a stack of its own, so that an overflow of the stack is handled too.
void catch_fatal_signals();

}  // namespace carom
