#pragma once

#include <cstddef>
#include <functional>

namespace carom {

/// The cancellation token of a tick: asks the caller now and then whether a long tick may go on.
class Patience {
  public:
    /// Work between two questions. A unit is about as much as testing one ball: some tens of
    /// nanoseconds.
    static constexpr std::size_t ask_every = 4096;

    /// An empty `keep_going` never cancels. It must outlive this.
    explicit Patience(const std::function<bool()>& keep_going) : keep_going_(keep_going) {}

    /// Counts units of work done. False once the tick is cancelled.
    bool lasts(std::size_t work) {
        if (!keep_going_ || is_out_) return !is_out_;
        since_ += work;
        if (since_ < ask_every) return true;
        since_ = 0;
        is_out_ = !keep_going_();
        return !is_out_;
    }
    /// Whether the tick is cancelled.
    bool is_out() const { return is_out_; }

  private:
    const std::function<bool()>& keep_going_;
    std::size_t since_ = 0;
    bool is_out_ = false;
};

}  // namespace carom
