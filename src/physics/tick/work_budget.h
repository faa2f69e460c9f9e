#pragma once

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
/// So a tick takes at most twice its budget, the balls that cost the most stop first, and the limit
/// changes no velocity and no energy.
class WorkBudget {
  public:
    /// What a solver may do in a tick.
    struct Allowance {
        std::uint64_t per_ball = 0;  ///< units of work
        std::size_t least_balls = 1000;
    };

    /// A tick, or one of `parts` equal parts of a tick, begins.
    void begin(std::size_t balls, const Allowance& allowance, int parts = 1) {
        balls_ = balls;
        limit_ = allowance.per_ball *
                 (balls < allowance.least_balls ? allowance.least_balls : balls) /
                 static_cast<std::uint64_t>(parts);
        spent_ = 0;
        charged_.clear();
    }
    /// Adds work that has been done. Returns whether the budget is used up.
    bool spend(std::uint64_t work) {
        spent_ += work;
        return spent_ > limit_;
    }
    /// Charges the work of an event to a ball. Returns whether the ball has used its share, so that
    /// time must stand still for it. Pre: the budget is used up.
    bool charge(std::uint32_t ball, std::uint64_t work);

  private:
    std::size_t balls_ = 0;
    std::uint64_t limit_ = 0;
    std::uint64_t spent_ = 0;
    std::vector<std::uint64_t> charged_;  // by ball, once the budget is used up
};

}  // namespace carom
