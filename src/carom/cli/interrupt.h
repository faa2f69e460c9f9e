#pragma once

namespace carom {

/// While a guard lives, INT, TERM and HUP are only recorded, so that the work can finish cleanly.
/// At most one guard lives at a time.
class InterruptGuard {
  public:
    InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    /// Restores the previous effect of the signals.
    ~InterruptGuard();

    /// The first signal received; 0: none.
    static int signal();
};

/// Ends the process the way `signal` would have, so that a shell sees the cause.
[[noreturn]] void die_of(int signal);

}  // namespace carom
