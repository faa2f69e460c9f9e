#pragma once

#include <cstddef>
#include <cstdint>

#include "physics/event/schedule/buckets.h"
#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

namespace carom {

/// Where the one valid entry of each ball in the event queue is: at an index of the heap, or in a
/// list or bucket under a generation, or nowhere.
///
/// A list or bucket may hold further entries of the ball. Their generations are outdated, so they
/// are void: to remove an entry takes one write here, wherever the entry is.
///
/// Every operation but `reset` is O(1).
class EntryMarks {
  public:
    /// Starts anew with balls 0..count-1, none of which has an entry.
    void reset(std::size_t count) { marks_.assign(count, nowhere); }

    std::size_t size() const { return marks_.size(); }
    bool is_in_heap(std::uint32_t ball) const { return (marks_[ball] & in_heap) != 0; }
    /// Pre: is_in_heap(ball).
    std::uint32_t heap_index(std::uint32_t ball) const { return marks_[ball] & ~in_heap; }
    /// Whether the entry of a list or bucket is still its ball's.
    bool is_valid(const QueuedEvent& event) const { return marks_[event.ball] == event.generation; }

    void put_in_heap(std::uint32_t ball, std::size_t index) {
        marks_[ball] = in_heap | static_cast<std::uint32_t>(index);
    }
    /// The ball has no entry; what lists and buckets hold of it is void.
    void remove(std::uint32_t ball) { marks_[ball] = nowhere; }

    /// The ball's new entry goes into a list or bucket: returns its generation, and makes earlier
    /// entries void. Pre: !is_used_up().
    std::uint32_t next_generation(std::uint32_t ball) { return marks_[ball] = ++generation_; }
    /// Whether all generations have been used: valid entries must be given new ones.
    bool is_used_up() const { return generation_ == last_generation; }
    /// Starts to count generations again. Pre: all lists and buckets are empty.
    void restart_generations() { generation_ = nowhere; }

    void prefetch(std::uint32_t ball) const { prefetch_line(&marks_[ball]); }

  private:
    /// A ball's mark is its index in the heap with this bit, or the generation of its entry.
    static constexpr std::uint32_t in_heap = 1u << 31;
    static constexpr std::uint32_t nowhere = 0;
    static constexpr std::uint32_t last_generation = in_heap - 1;

    LargeVector<std::uint32_t> marks_;    ///< by ball
    std::uint32_t generation_ = nowhere;  ///< the last that was given
};

}  // namespace carom
