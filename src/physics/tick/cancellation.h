#pragma once

#include <cstddef>
#include <functional>

namespace carom {

/// Asks now and then in a long tick whether it may go on.
class Patience {
  public:
    /// Work between two questions. A unit is about a look at one ball: some tens of nanoseconds.
    static constexpr std::size_t ask_every = 4096;

    /// Without `keep_going` there is no end to it.
    explicit Patience(const std::function<bool()>& keep_going) : keep_going_(keep_going) {}

    /// So many units of work have been done. False once the tick is to be given up.
    bool lasts(std::size_t work) {
        if (!keep_going_ || is_out_) return !is_out_;
        since_ += work;
        if (since_ < ask_every) return true;
        since_ = 0;
        is_out_ = !keep_going_();
        return !is_out_;
    }
    bool is_out() const { return is_out_; }

  private:
    const std::function<bool()>& keep_going_;
    std::size_t since_ = 0;
    bool is_out_ = false;
};

}  // namespace carom
