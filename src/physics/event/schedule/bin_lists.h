#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/event/schedule/buckets.h"
#include "physics/event/schedule/entry_marks.h"

namespace carom {

/// An unordered list of queued events for each of the next bins of the event queue. Bin i has list
/// i mod the number of lists, so the caller keeps to as many bins at a time.
///
/// Lists share nodes, which are used again. Finding the next bin with entries takes a bit a list.
/// Cost: O(1) an operation, and one step a node where it says so.
class BinLists {
  public:
    static constexpr std::uint32_t no_node = 0xffffffffu;

    /// Makes `lists` empty lists, and room for `expected` entries. Pre: a power of two, at least
    /// 64. Cost: O(lists).
    void reset(std::size_t lists, std::size_t expected) {
        heads_.assign(lists, no_node);
        is_filled_.assign(lists / 64, 0);
        nodes_.clear();
        nodes_.reserve(expected);
        free_node_ = no_node;
        size_ = 0;
    }

    /// The number of entries, void ones included.
    std::size_t size() const { return size_; }

    void add(std::uint64_t bin, QueuedEvent event) {
        const std::uint32_t list = list_of(bin);
        if (free_node_ == no_node) add_node();
        const std::uint32_t at = free_node_;
        Node& node = nodes_[at];
        free_node_ = node.next;
        node.event = event;
        node.next = heads_[list];
        heads_[list] = at;
        is_filled_[list / 64] |= std::uint64_t{1} << (list % 64);
        ++size_;
    }

    /// Empties the bin's list, and calls visit(event) for what was in it. One step a node.
    template <typename Visit>
    void empty(std::uint64_t bin, Visit&& visit) {
        const std::uint32_t list = list_of(bin);
        std::uint32_t node = heads_[list];
        heads_[list] = no_node;
        is_filled_[list / 64] &= ~(std::uint64_t{1} << (list % 64));
        while (node != no_node) {
            const QueuedEvent event = nodes_[node].event;
            const std::uint32_t next = nodes_[node].next;
            nodes_[node].next = free_node_;
            free_node_ = node;
            node = next;
            --size_;
            visit(event);
        }
    }

    /// Calls visit(event) for each entry of the bin. One step a node.
    template <typename Visit>
    void for_each(std::uint64_t bin, Visit&& visit) const {
        for (std::uint32_t node = heads_[list_of(bin)]; node != no_node; node = nodes_[node].next)
            visit(nodes_[node].event);
    }

    /// The first bin in `bin`..`end` - 1 with entries, void ones included; else `end`. One step for
    /// 64 lists.
    std::uint64_t filled_from(std::uint64_t bin, std::uint64_t end) const {
        while (bin < end) {
            const std::uint32_t list = list_of(bin);
            const std::uint64_t bits = is_filled_[list / 64] >> (list % 64);
            if (bits != 0)
                return std::min(bin + static_cast<std::uint64_t>(std::countr_zero(bits)), end);
            bin += 64 - list % 64;
        }
        return end;
    }

    /// The first node of the bin with a valid entry; else `no_node`. One step a node.
    std::uint32_t first_valid(std::uint64_t bin, const EntryMarks& marks) const {
        return valid_from(heads_[list_of(bin)], marks);
    }
    /// The next such node of the same list.
    std::uint32_t next_valid(std::uint32_t node, const EntryMarks& marks) const {
        return valid_from(nodes_[node].next, marks);
    }
    std::uint32_t ball(std::uint32_t node) const { return nodes_[node].event.ball; }

  private:
    /// An entry of a list, or a free node.
    struct Node {
        QueuedEvent event;
        std::uint32_t next = no_node;
    };

    std::uint32_t list_of(std::uint64_t bin) const {
        return static_cast<std::uint32_t>(bin & (heads_.size() - 1));
    }
    std::uint32_t valid_from(std::uint32_t node, const EntryMarks& marks) const {
        while (node != no_node && !marks.is_valid(nodes_[node].event))
            node = nodes_[node].next;
        return node;
    }
    // Rare: nodes are used again.
    [[gnu::noinline]] void add_node() {
        free_node_ = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({});
    }

    std::vector<std::uint32_t> heads_;      ///< by list: its first node
    std::vector<std::uint64_t> is_filled_;  ///< a bit for each list
    std::vector<Node> nodes_;
    std::uint32_t free_node_ = no_node;  ///< the first of the free nodes, a chain
    std::size_t size_ = 0;
};

}  // namespace carom
