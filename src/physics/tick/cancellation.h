#pragma once

#include <cstddef>
#include <functional>

namespace carom {

/// The cancellation token of a tick: asks the caller now and then whether a long tick may continue.
class CancellationToken {
  public:
    /// Work between two questions. A unit is about as much as testing one ball: some tens of
    /// nanoseconds.
    static constexpr std::size_t ask_every = 4096;

    /// An empty `keep_going` never cancels. It must outlive this.
    explicit CancellationToken(const std::function<bool()>& keep_going) : keep_going_(keep_going) {}

    /// Counts units of work done. False once the tick is cancelled.
    bool may_continue(std::size_t work) {
        if (!keep_going_ || is_cancelled_) return !is_cancelled_;
        since_ += work;
        if (since_ < ask_every) return true;
        since_ = 0;
        is_cancelled_ = !keep_going_();
        return !is_cancelled_;
    }
    /// Whether the tick is cancelled.
    bool is_cancelled() const { return is_cancelled_; }

  private:
    const std::function<bool()>& keep_going_;
    std::size_t since_ = 0;
    bool is_cancelled_ = false;
};

}  // namespace carom
