#pragma once

namespace carom {

/// While it lives, INT, TERM and HUP are only noted, so that the work can end in good order. At
/// most one guard lives at a time.
class InterruptGuard {
  public:
    InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    /// Restores what the signals did before.
    ~InterruptGuard();

    /// The first signal that came; 0: none.
    static int signal();
};

/// Ends the process as `signal` would have, so that a shell sees what stopped it.
[[noreturn]] void die_of(int signal);

}  // namespace carom
