#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "physics/event/motion/ball_cells.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/tolerances.h"
#include "physics/event/schedule/queue.h"

namespace carom {

/// Which ball has the next event: an EventQueue of one entry a ball, its BallPlan::next_event().
///
/// Code that changes a ball's next event calls `update`. Where there are many balls, `first` also
/// prefetches what the events after it will read.
template <typename Real>
class Schedule {
  public:
    Schedule(const BallTable<Real>& balls, const BallCells<Real>& cells)
        : balls_(balls), cells_(cells) {}

    /// Takes the next events of all balls anew. Cost: O(n).
    void rebuild();
    /// The next event of `ball` has changed. Cost: O(log of the events of the present bin).
    void update(std::uint32_t ball);

    /// The ball whose event comes first, in the order of `comes_before`; nothing if no ball has
    /// one. Inlined, so that the result stays in registers.
    [[gnu::always_inline]] std::optional<std::uint32_t> first() {
        if (balls_.size() >= balls_worth_prefetching) prefetch();
        return queue_.first([this](std::uint32_t a, std::uint32_t b) { return is_before(a, b); });
    }

  private:
    /// A ball whose event comes soon, and what of it is known.
    struct Upcoming {
        std::uint32_t ball = 0;
        std::uint32_t partner = 0;  ///< the ball it meets, or itself
        std::uint32_t cell = 0;     ///< around which its event will look
        std::uint32_t partner_cell = 0;
        std::uint32_t direction = BallCells<Real>::no_direction;  ///< of a cell transfer
    };

    bool is_before(std::uint32_t a, std::uint32_t b) const {
        return comes_before(a, balls_.plan(a).next_event(), b, balls_.plan(b).next_event());
    }
    double queue_time(std::uint32_t ball) const;
    void prefetch();

    const BallTable<Real>& balls_;
    const BallCells<Real>& cells_;
    EventQueue queue_;
    std::array<Upcoming, 8> upcoming_{};  ///< a ring, for `prefetch`
    std::uint32_t last_upcoming_ = 0;
};

}  // namespace carom
