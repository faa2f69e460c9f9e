#pragma once

#include <cstdint>
#include <vector>

/// The event queue: a binary heap of the balls, the one with the earliest event on top, in which
/// the place of every ball is known, so that its event can be replaced.
namespace carom {

class EventQueue {
  public:
    /// Balls 0..count-1, in no order yet: call `build` before anything else.
    void reset(std::size_t count) {
        heap_.resize(count);
        place_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i)
            heap_[i] = place_[i] = i;
    }

    bool is_empty() const { return heap_.empty(); }
    std::uint32_t first() const { return heap_.front(); }

    /// `is_before(a, b)`: whether ball a's event comes before ball b's, a total order.
    template <typename Before>
    void build(Before&& is_before) {
        for (std::size_t i = heap_.size() / 2; i-- > 0;)
            sink(i, is_before);
    }

    /// The event of `ball` has changed.
    template <typename Before>
    void update(std::uint32_t ball, Before&& is_before) {
        rise(place_[ball], is_before);
        sink(place_[ball], is_before);
    }

  private:
    template <typename Before>
    void rise(std::size_t at, Before&& is_before) {
        const std::uint32_t ball = heap_[at];
        while (at > 0) {
            const std::size_t above = (at - 1) / 2;
            if (!is_before(ball, heap_[above])) break;
            put(heap_[above], at);
            at = above;
        }
        put(ball, at);
    }

    template <typename Before>
    void sink(std::size_t at, Before&& is_before) {
        const std::uint32_t ball = heap_[at];
        for (;;) {
            std::size_t below = 2 * at + 1;
            if (below >= heap_.size()) break;
            if (below + 1 < heap_.size() && is_before(heap_[below + 1], heap_[below])) ++below;
            if (!is_before(heap_[below], ball)) break;
            put(heap_[below], at);
            at = below;
        }
        put(ball, at);
    }

    void put(std::uint32_t ball, std::size_t at) {
        heap_[at] = ball;
        place_[ball] = static_cast<std::uint32_t>(at);
    }

    std::vector<std::uint32_t> heap_;
    std::vector<std::uint32_t> place_;
};

}  // namespace carom
