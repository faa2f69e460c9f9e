#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

namespace carom {

/// What the event queue keeps of a ball's event until it comes: void once the ball has got another
/// stamp.
struct QueuedEvent {
    double time = 0.0;
    std::uint32_t ball = 0;
    std::uint32_t stamp = 0;
};

/// Bags of queued events, in no order, each filled from one end and emptied as a whole: memory is
/// gone through from end to end then, and what is put in lies beside what was put in before. All
/// share their chunks of memory, and once `reset` nothing is allocated.
class EventBags {
  public:
    /// All empty, with room for `most` events in all.
    void reset(std::size_t bags, std::size_t most) {
        ends_.assign(bags, none << chunk_bits);
        const std::size_t chunks = 1 + most / chunk_size + bags + 1;
        if (chunks_.size() < chunks) chunks_.resize(chunks);
        for (std::size_t i = 0; i < chunks_.size(); ++i)
            chunks_[i].next = static_cast<std::uint32_t>(i + 1);
        // Nothing comes after these two.
        chunks_[none].next = chunks_.back().next = none;
        free_ = none + 1;
        size_ = 0;
        soon_ = none;
    }

    std::size_t size() const { return size_; }

    void add(std::size_t bag, QueuedEvent event) {
        std::uint32_t end = ends_[bag];
        if ((end & room_mask) == 0) {
            const std::uint32_t chunk = free_;
            free_ = chunks_[chunk].next;
            chunks_[chunk].next = end >> chunk_bits;
            end = chunk << chunk_bits | chunk_size;
        }
        ends_[bag] = --end;
        chunks_[end >> chunk_bits].events[end & room_mask] = event;
        ++size_;
    }

    /// Calls visit(event) for all that are in the bag, which is empty then. The visit may add to
    /// bags, this one included.
    template <typename Visit>
    void empty(std::size_t bag, Visit&& visit) {
        std::uint32_t chunk = ends_[bag] >> chunk_bits;
        std::uint32_t first = ends_[bag] & room_mask;
        ends_[bag] = none << chunk_bits;
        while (chunk != none) {
            for (std::uint32_t i = first; i < chunk_size; ++i)
                visit(chunks_[chunk].events[i]);
            size_ -= chunk_size - first;
            const std::uint32_t next = chunks_[chunk].next;
            chunks_[chunk].next = free_;
            free_ = chunk;
            chunk = next;
            first = 0;
        }
    }

    /// The bag is going to be emptied: each call of `fetch_more` brings a chunk of it into the
    /// cache, until there are no more, and calls fetch(ball) for those in the one before,
    /// and where that is not full for any number.
    void fetch_soon(std::size_t bag) { soon_ = ends_[bag] >> chunk_bits; }
    template <typename Fetch>
    void fetch_more(Fetch&& fetch) {
        if (soon_ == none) return;
        for (const QueuedEvent& event : chunks_[soon_].events)
            fetch(event.ball);
        soon_ = chunks_[soon_].next;
        const Chunk& chunk = chunks_[soon_];
        for (std::size_t i = 0; i < chunk_size; i += 4)
            fetch_early(&chunk.events[i]);
    }

  private:
    static constexpr std::uint32_t none = 0;  ///< the first chunk is in use nowhere
    static constexpr std::uint32_t chunk_size = 15;
    static constexpr int chunk_bits = 4;
    static constexpr std::uint32_t room_mask = 15;

    struct alignas(64) Chunk {
        std::array<QueuedEvent, chunk_size> events;
        std::uint32_t next = none;
    };

    LargeVector<Chunk> chunks_;
    /// By bag: its last chunk, and how much room is in that; those before it are full.
    std::vector<std::uint32_t> ends_;
    std::uint32_t free_ = none;  ///< the first of the chunks that are in no bag
    std::uint32_t soon_ = none;
    std::size_t size_ = 0;
};

}  // namespace carom
