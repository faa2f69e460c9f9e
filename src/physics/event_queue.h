#pragma once

#include <cstdint>
#include <vector>

/// The event queue: a heap of the balls, each with four below it, the one with the earliest event
/// on top, in which the place of every ball is known, so that its event can be replaced.
///
/// The times stand in the heap itself, so that nearly all comparisons read nothing else: who comes
/// first at the same time is asked where times are equal.
namespace carom {

class EventQueue {
  public:
    /// Balls 0..count-1, in no order yet: call `build` before anything else.
    void reset(std::size_t count) {
        heap_.resize(count);
        place_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i)
            put({0.0, i}, i);
    }

    bool is_empty() const { return heap_.empty(); }
    std::uint32_t first() const { return heap_.front().ball; }

    /// `time_of(ball)`: of its event, s. `is_before(a, b)`: whether ball a's event comes before
    /// ball b's, a total order that goes by time first.
    template <typename Time, typename Before>
    void build(Time&& time_of, Before&& is_before) {
        for (Entry& entry : heap_)
            entry.time = time_of(entry.ball);
        for (std::size_t i = (heap_.size() + 2) / 4; i-- > 0;)
            sink(i, heap_[i], is_before);
    }

    /// The event of `ball` has changed, and is at `time` now.
    template <typename Before>
    void update(std::uint32_t ball, double time, Before&& is_before) {
        const Entry entry{time, ball};
        const std::size_t at = place_[ball];
        if (at > 0 && comes_first(entry, heap_[(at - 1) / 4], is_before))
            rise(at, entry, is_before);
        else
            sink(at, entry, is_before);
    }

  private:
    struct Entry {
        double time = 0.0;
        std::uint32_t ball = 0;
    };

    template <typename Before>
    static bool comes_first(const Entry& a, const Entry& b, Before&& is_before) {
        return a.time < b.time || (a.time == b.time && is_before(a.ball, b.ball));
    }

    template <typename Before>
    void rise(std::size_t at, const Entry entry, Before&& is_before) {
        while (at > 0) {
            const std::size_t above = (at - 1) / 4;
            if (!comes_first(entry, heap_[above], is_before)) break;
            put(heap_[above], at);
            at = above;
        }
        put(entry, at);
    }

    template <typename Before>
    void sink(std::size_t at, const Entry entry, Before&& is_before) {
        for (;;) {
            const std::size_t begin = 4 * at + 1;
            if (begin >= heap_.size()) break;
            const std::size_t end = begin + 4 < heap_.size() ? begin + 4 : heap_.size();
            std::size_t least = begin;
            for (std::size_t below = begin + 1; below < end; ++below)
                if (comes_first(heap_[below], heap_[least], is_before)) least = below;
            if (!comes_first(heap_[least], entry, is_before)) break;
            put(heap_[least], at);
            at = least;
        }
        put(entry, at);
    }

    void put(const Entry& entry, std::size_t at) {
        heap_[at] = entry;
        place_[entry.ball] = static_cast<std::uint32_t>(at);
    }

    std::vector<Entry> heap_;
    std::vector<std::uint32_t> place_;
};

}  // namespace carom
