#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom {

/// How much work `swept` and `event` may do in one tick, and for which balls time stands still
/// beyond it. `contact` gives each ball a fixed number of impacts a substep, with the same
/// consequence (contact/paths.h); `discrete` and `substep` do a fixed amount of work.
///
/// Work is counted in units of the solver, such as events or tests of a pair, never in seconds, so
/// the result is the same on every machine.
///
/// - The budget of a tick of n balls is `per_ball` times n units, or times `least_balls` if there
///   are fewer: at most about a second of one core for 1,000 balls.
/// - Once it is spent, as much work again is shared out among the balls, and each event is charged
///   to the balls that take part in it.
/// - When a ball has used its share, *time stands still* for it: until the tick ends it stays where
///   it is, an obstacle to all others, and keeps its velocity. In the next tick it continues.
///
/// - A tick that hands, movers or a hybrid step repeat (hands.h, mover_step.h,
///   event/hybrid_step.h) has one budget for all its trials: each gets what the trials before it
///   have left. Once nothing is left, each further trial shares out half as much as the one before.
///
/// So a tick takes at most twice its budget, and three times if it is repeated; the balls that cost
/// the most stop first; and the limit changes no velocity and no energy.
class WorkBudget {
  public:
    /// What a solver may do in a tick.
    struct Allowance {
        std::uint64_t per_ball = 0;  ///< units of work
        std::size_t least_balls = 1000;
    };

    /// A tick begins, or is repeated.
    void begin(std::size_t balls, const Allowance& allowance, bool is_repeated) {
        balls_ = balls;
        if (!is_repeated) {
            left_ = shared_ = allowance.per_ball * std::max(balls, allowance.least_balls);
        } else {
            left_ -= std::min(left_, spent_);
            if (left_ == 0) shared_ /= 2;
        }
        spent_ = 0;
        begin_part(1);
    }
    /// One of `parts` equal parts of the tick begins.
    void begin_part(std::uint64_t parts) {
        limit_ = left_ / parts;
        share_ = balls_ > 0 ? shared_ / parts / balls_ : 0;
        spent_in_part_ = 0;
        charged_.clear();
    }
    /// Adds work that has been done. Returns whether the budget is used up.
    bool spend(std::uint64_t work) {
        spent_ += work;
        spent_in_part_ += work;
        return spent_in_part_ > limit_;
    }
    /// Charges the work of an event to a ball. Returns whether the ball has used its share, so that
    /// time must stand still for it. Pre: the budget is used up.
    bool charge(std::uint32_t ball, std::uint64_t work);

  private:
    std::size_t balls_ = 0;
    std::uint64_t left_ = 0;    // of the budget, for this trial of the tick
    std::uint64_t shared_ = 0;  // among the balls, beyond that
    std::uint64_t spent_ = 0;   // in this trial
    std::uint64_t limit_ = 0;   // of this part
    std::uint64_t share_ = 0;   // of each ball in this part
    std::uint64_t spent_in_part_ = 0;
    std::vector<std::uint64_t> charged_;  // by ball, once the budget is used up
};

}  // namespace carom
