#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

namespace carom {

/// An entry of the event queue. It is void once its ball has another generation.
struct QueuedEvent {
    double time = 0.0;
    std::uint32_t ball = 0;
    std::uint32_t generation = 0;
};

/// Buckets of queued events, in no order. Each is filled from one end and emptied as a whole, so
/// memory is read and written from end to end. All buckets share chunks of memory, and nothing is
/// allocated after `reset`.
class EventBuckets {
  public:
    /// Makes them empty, with room for `most` events in all. Cost: O(buckets + most).
    void reset(std::size_t buckets, std::size_t most) {
        ends_.assign(buckets, none << chunk_bits);
        const std::size_t chunks = 1 + most / chunk_size + buckets + 1;
        if (chunks_.size() < chunks) chunks_.resize(chunks);
        for (std::size_t i = 0; i < chunks_.size(); ++i)
            chunks_[i].next = static_cast<std::uint32_t>(i + 1);
        // The ends of the chains.
        chunks_[none].next = chunks_.back().next = none;
        free_ = none + 1;
        size_ = 0;
        soon_ = none;
    }

    std::size_t size() const { return size_; }

    void add(std::size_t bucket, QueuedEvent event) {
        std::uint32_t end = ends_[bucket];
        if ((end & room_mask) == 0) {
            const std::uint32_t chunk = free_;
            free_ = chunks_[chunk].next;
            chunks_[chunk].next = end >> chunk_bits;
            end = chunk << chunk_bits | chunk_size;
        }
        ends_[bucket] = --end;
        chunks_[end >> chunk_bits].events[end & room_mask] = event;
        ++size_;
    }

    /// Empties the bucket, and calls visit(event) for what was in it. The visit may add to any
    /// bucket.
    template <typename Visit>
    void empty(std::size_t bucket, Visit&& visit) {
        std::uint32_t chunk = ends_[bucket] >> chunk_bits;
        std::uint32_t first = ends_[bucket] & room_mask;
        ends_[bucket] = none << chunk_bits;
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

    /// The bucket will be emptied soon: each call of `prefetch_more` prefetches one of its chunks,
    /// until there are no more, and calls fetch(ball) for the balls of the chunk before. Where that
    /// chunk is not full, fetch is called with arbitrary numbers.
    void prefetch_soon(std::size_t bucket) { soon_ = ends_[bucket] >> chunk_bits; }
    template <typename Fetch>
    void prefetch_more(Fetch&& fetch) {
        if (soon_ == none) return;
        for (const QueuedEvent& event : chunks_[soon_].events)
            fetch(event.ball);
        soon_ = chunks_[soon_].next;
        const Chunk& chunk = chunks_[soon_];
        for (std::size_t i = 0; i < chunk_size; i += 4)
            prefetch_line(&chunk.events[i]);
    }

  private:
    static constexpr std::uint32_t none = 0;  ///< the first chunk is never used
    static constexpr std::uint32_t chunk_size = 15;
    static constexpr int chunk_bits = 4;
    static constexpr std::uint32_t room_mask = 15;

    struct alignas(64) Chunk {
        std::array<QueuedEvent, chunk_size> events;
        std::uint32_t next = none;
    };

    LargeVector<Chunk> chunks_;
    /// By bucket: its last chunk, and how much room is left in it; those before it are full.
    std::vector<std::uint32_t> ends_;
    std::uint32_t free_ = none;  ///< the first chunk that is in no bucket
    std::uint32_t soon_ = none;
    std::size_t size_ = 0;
};

}  // namespace carom
