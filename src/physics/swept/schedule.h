#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/vec2.h"
#include "physics/ccd/impact_queue.h"
#include "physics/world/contact.h"

namespace carom {

/// The first impact of a ball in a substep of the solver `swept`, as predicted.
struct SweptEvent {
    double time = 0.0;  ///< s since the substep began
    ContactKind kind = ContactKind::ball_ball;
    std::uint32_t ball = 0;   ///< whose prediction this is
    std::uint32_t other = 0;  ///< a ball or a capsule
    std::uint32_t ball_version = 0;
    std::uint32_t other_version = 0;
    Vec2 normal;  ///< from other to ball

    auto tie_break() const {
        const bool on_ball = kind == ContactKind::ball_ball;
        return std::tuple(kind, on_ball ? std::min(ball, other) : ball,
                          on_ball ? std::max(ball, other) : other, ball);
    }
};

/// The predicted impacts of a substep, earliest first (ccd/impact_queue.h has the order). Most are
/// known when it begins: these are sorted once by bins of time, which is cheaper than a heap. What
/// is predicted later goes through a heap.
class SweptSchedule {
  public:
    void clear();
    /// An event that is known when the substep begins. Pre: time in 0..duration.
    void add_initial(const SweptEvent& event) { unsorted_.push_back(event); }
    /// Once all initial events are known. Cost: linear where times are spread evenly.
    void sort_initial(double duration);
    void push(const SweptEvent& event) { queue_.push(event); }
    /// Takes out the earliest event of all.
    std::optional<SweptEvent> take() {
        took_initial_ = next_initial_ < initial_.size() &&
                        (queue_.is_empty() || is_earlier(initial_[next_initial_], queue_.first()));
        if (took_initial_) return initial_[next_initial_++];
        if (queue_.is_empty()) return std::nullopt;
        return queue_.pop();
    }
    /// The initial event that comes `ahead` places behind the next one, for prefetching; null if
    /// there are not that many, or if the last event taken was not an initial one.
    const SweptEvent* upcoming(std::size_t ahead) const {
        return took_initial_ && next_initial_ + ahead < initial_.size()
                   ? &initial_[next_initial_ + ahead]
                   : nullptr;
    }

  private:
    std::vector<SweptEvent> unsorted_;
    std::vector<SweptEvent> initial_;  // in order; those before next_initial_ are done
    std::size_t next_initial_ = 0;
    bool took_initial_ = false;
    ImpactQueue<SweptEvent> queue_;
    std::vector<std::uint32_t> bin_start_;  // scratch of sort_initial: of bins, in initial_
};

}  // namespace carom
