#pragma once

#include <cstdint>
#include <functional>

#include "geometry/conservative_advancement.h"
#include "physics/event/motion/tolerances.h"

namespace carom {

/// Measures the work of a tick in events, and polls its cancellation token after every
/// `events_between_polls`. Rounds of an impact and iterations of TOI searches count too, so that
/// slow events are followed by a poll sooner. It polls between two events, and between two balls
/// when all are predicted anew, never within an event.
template <typename Real>
class WorkMeter {
  public:
    /// A tick begins. `keep_going`, which must outlive it, may be empty.
    void begin(const std::function<bool()>& keep_going) {
        keep_going_ = &keep_going;
        events_ = rounds_ = 0;
        search_.iterations = 0;
        next_poll_ = events_between_polls;
        is_cancelled_ = false;
    }
    void count_event() { ++events_; }
    void count_rounds(std::uint64_t rounds) { rounds_ += rounds; }
    std::uint64_t events() const { return events_; }

    /// Of the TOI searches of this tick.
    ToiSearch<Real>& search() { return search_; }
    const ToiSearch<Real>& search() const { return search_; }

    /// Asks the token, if that is due. Once false, it stays so until the tick is over.
    bool may_go_on() {
        const std::uint64_t done = events_ + rounds_ + search_.iterations / iterations_per_event;
        if (done < next_poll_) return !is_cancelled_;
        next_poll_ = done + events_between_polls;
        if (*keep_going_ && !(*keep_going_)()) is_cancelled_ = true;
        return !is_cancelled_;
    }
    bool is_cancelled() const { return is_cancelled_; }

  private:
    ToiSearch<Real> search_;
    const std::function<bool()>* keep_going_ = nullptr;  ///< during a tick
    std::uint64_t events_ = 0;
    std::uint64_t rounds_ = 0;  ///< of impacts, in events that take about as long
    std::uint64_t next_poll_ = 0;
    bool is_cancelled_ = false;
};

}  // namespace carom
