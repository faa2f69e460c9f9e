#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/fetch.h"
#include "physics/large_pages.h"

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
        bags_.assign(bags, {});
        const std::size_t chunks = most / chunk_size + bags + 1;
        if (chunks_.size() < chunks) chunks_.resize(chunks);
        for (std::size_t i = 0; i < chunks_.size(); ++i)
            chunks_[i].next = static_cast<std::uint32_t>(i + 1);
        free_ = 0;
        size_ = 0;
    }

    std::size_t size() const { return size_; }

    void add(std::size_t bag, const QueuedEvent& event) {
        Bag& into = bags_[bag];
        if (into.room == 0) {
            const std::uint32_t chunk = free_;
            free_ = chunks_[chunk].next;
            chunks_[chunk].next = into.chunk;
            into = {chunk, chunk_size};
        }
        chunks_[into.chunk].events[--into.room] = event;
        ++size_;
    }

    /// Calls visit(event) for all that are in the bag, which is empty then. The visit may add to
    /// bags, this one included.
    template <typename Visit>
    void empty(std::size_t bag, Visit&& visit) {
        Bag from = bags_[bag];
        bags_[bag] = {};
        while (from.chunk != none) {
            const Chunk& chunk = chunks_[from.chunk];
            const std::uint32_t next = chunk.next;
            if (next != none)
                for (std::size_t i = 0; i < chunk_size; i += 4)
                    fetch_early(&chunks_[next].events[i]);
            for (std::uint32_t i = from.room; i < chunk_size; ++i)
                visit(chunk.events[i]);
            size_ -= chunk_size - from.room;
            chunks_[from.chunk].next = free_;
            free_ = from.chunk;
            from = {next, 0};
        }
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr std::uint32_t chunk_size = 15;

    struct alignas(64) Chunk {
        std::array<QueuedEvent, chunk_size> events;
        std::uint32_t next = none;
    };
    struct Bag {
        std::uint32_t chunk = none;  ///< the last
        std::uint32_t room = 0;      ///< in it; those before it are full
    };

    LargeVector<Chunk> chunks_;
    std::vector<Bag> bags_;
    std::uint32_t free_ = none;  ///< the first of the chunks that are in no bag
    std::size_t size_ = 0;
};

}  // namespace carom
