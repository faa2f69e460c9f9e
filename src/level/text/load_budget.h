#pragma once

#include <cstdint>

#include "level/text/reporter.h"

/// Bounds the work of loading. A level is untrusted data, and a short one can ask for years of it.
namespace carom {

/// Counts operations, not seconds, so that every machine refuses the same files. One operation is
/// worth about 7 ns. Work that keeps memory costs an operation for each byte or so.
class LoadBudget {
  public:
    explicit LoadBudget(Reporter& reporter) : reporter_(reporter) {}
    LoadBudget(const LoadBudget&) = delete;
    LoadBudget& operator=(const LoadBudget&) = delete;

    /// The statement that the following work belongs to, for the message at the limit.
    void begin(const Span& statement) { statement_ = statement; }
    /// Counts work. Stops loading (Reporter::stop) if it is more than the budget has left.
    void spend(std::uint64_t operations) {
        spent_ += operations;
        if (spent_ > allowed_) stop();
    }
    std::uint64_t spent() const { return spent_; }
    /// The operations that are left.
    std::uint64_t left() const { return allowed_ - spent_; }
    /// A level may cost more for each item that it makes.
    void earn(std::uint64_t items) { allowed_ += items * of_an_item; }

  private:
    static constexpr std::uint64_t of_any_level = 60'000'000;  // 0.4 s
    static constexpr std::uint64_t of_an_item = 75;            // 0.5 us

    [[noreturn]] void stop() const {
        reporter_.stop("too-much-work", statement_, "the level takes too much work to load",
                       "repeat less, or draw and fill with less in one place");
    }

    Reporter& reporter_;
    Span statement_;
    std::uint64_t spent_ = 0;
    std::uint64_t allowed_ = of_any_level;
};

}  // namespace carom
