#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "geometry/conservative_advancement.h"
#include "physics/event/motion/tolerances.h"
#include "physics/tick/work_budget.h"

namespace carom {

/// Measures the work of a tick in events: polls its cancellation token after every
/// `events_between_polls`, and says when the budget of the tick (tick/work_budget.h) is used up.
/// Rounds of an impact and iterations of TOI searches count too, so that
/// slow events are followed by a poll sooner. It polls between two events, and between two balls
/// when all are predicted anew, never within an event.
template <typename Real>
class WorkMeter {
  public:
    /// The next tick counts as new, even if `begin` says that it is repeated.
    void forget_trials() { has_begun_ = false; }
    /// A tick begins, or is repeated (WorkBudget::begin). `keep_going`, which must outlive it, may
    /// be empty.
    void begin(const std::function<bool()>& keep_going, std::size_t balls,
               bool is_repeated = false) {
        keep_going_ = &keep_going;
        if (!is_over_budget_) budget_.spend(work() - polled_);
        budget_.begin(balls, event_budget, is_repeated && has_begun_);
        has_begun_ = true;
        events_ = rounds_ = 0;
        search_.iterations = 0;
        polled_ = 0;
        next_poll_ = events_between_polls;
        is_cancelled_ = is_over_budget_ = false;
    }
    void count_event() { ++events_; }
    void count_rounds(std::uint64_t rounds) { rounds_ += rounds; }

    /// The TOI search, which counts the iterations of this tick.
    ToiSearch<Real>& search() { return search_; }
    const ToiSearch<Real>& search() const { return search_; }

    /// Asks the token, if that is due. Once false, it stays so until the tick is over.
    bool may_go_on() {
        if (done() < next_poll_) return !is_cancelled_;
        poll();
        return !is_cancelled_;
    }
    bool is_cancelled() const { return is_cancelled_; }

    /// Whether the tick has used up its budget; changes only at polls.
    bool is_over_budget() const { return is_over_budget_; }
    /// The work since the last call or poll. Pre, as for `charge`: the tick is over its budget.
    std::uint64_t take_uncharged() { return work() - std::exchange(charged_, work()); }
    /// Whether time must stand still for the ball: see WorkBudget::charge.
    bool charge(std::uint32_t ball, std::uint64_t work) { return budget_.charge(ball, work); }

  private:
    std::uint64_t done() const {
        return events_ + rounds_ + search_.iterations / iterations_per_event;
    }
    std::uint64_t work() const {
        return events_ + rounds_ + search_.iterations / iterations_per_unit;
    }
    void poll() {
        if (!is_over_budget_ && budget_.spend(work() - std::exchange(polled_, work()))) {
            is_over_budget_ = true;
            charged_ = work();
        }
        next_poll_ = done() + events_between_polls;
        if (*keep_going_ && !(*keep_going_)()) is_cancelled_ = true;
    }

    ToiSearch<Real> search_;
    WorkBudget budget_;
    const std::function<bool()>* keep_going_ = nullptr;  ///< during a tick
    std::uint64_t events_ = 0;
    std::uint64_t rounds_ = 0;  ///< of impacts, in events that take about as long
    std::uint64_t next_poll_ = 0;
    std::uint64_t polled_ = 0;   ///< work at the last poll
    std::uint64_t charged_ = 0;  ///< work when some was charged last
    bool is_cancelled_ = false;
    bool is_over_budget_ = false;
    bool has_begun_ = false;  ///< in a trial of this tick
};

}  // namespace carom
