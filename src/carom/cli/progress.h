#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace carom {

/// A progress bar on standard error for work of more than a second. Draws nothing where standard
/// error is not a terminal. `clear` and the destructor remove the bar.
class Progress {
  public:
    explicit Progress(std::uint64_t total_ticks);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// Redraws at most ten times a second, so it may be called every tick.
    void update(std::uint64_t ticks_done);
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    std::uint64_t total_;
    bool is_terminal_;
    Clock::time_point start_;
    Clock::time_point next_;
    std::size_t drawn_ = 0;  // columns drawn on the line
};

/// What a computation calls with the ticks done and their total: shows a progress bar, and is false
/// after a signal that ends the program.
class ProgressOrSignal {
  public:
    bool operator()(std::uint64_t done, std::uint64_t total);

  private:
    std::optional<Progress> progress_;
};

}  // namespace carom
