#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace carom {

/// A progress bar on standard error for work of more than a second, where standard error is a
/// terminal; nothing otherwise. `clear` and the destructor remove it.
class Progress {
  public:
    explicit Progress(std::uint64_t total_ticks);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// Redraws ten times a second at most, so it may be called every tick.
    void update(std::uint64_t ticks_done);
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    std::uint64_t total_;
    bool is_terminal_;
    Clock::time_point start_;
    Clock::time_point next_;
    std::size_t drawn_ = 0;  // columns that stand on the line
};

}  // namespace carom
