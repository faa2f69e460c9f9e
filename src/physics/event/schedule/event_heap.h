#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/event/schedule/entry_marks.h"

namespace carom {

/// The events that come next, in the event queue: a heap with four children a node.
///
/// `is_before(a, b)` decides which of two balls with events at the same time comes first; it must
/// be the same total order in every call. The heap writes into `marks`, the same object in every
/// call, at which index each ball is.
///
/// Cost: O(log size) an operation; `first` O(1).
class EventHeap {
  public:
    struct Entry {
        double time = 0.0;  ///< s
        std::uint32_t ball = 0;
    };

    bool is_empty() const { return entries_.empty(); }
    /// Marks keep their values: the caller resets them.
    void clear() { entries_.clear(); }
    /// Pre: not empty.
    const Entry& first() const { return entries_.front(); }

    /// Pre: the heap has no entry of this ball.
    template <typename Before>
    void add(const Entry& entry, EntryMarks& marks, Before&& is_before) {
        entries_.push_back({});
        rise(entries_.size() - 1, entry, marks, is_before);
    }

    /// Removes the entry at this index. Its ball's mark stays.
    template <typename Before>
    void remove(std::size_t at, EntryMarks& marks, Before&& is_before) {
        const Entry last = entries_.back();
        entries_.pop_back();
        if (at < entries_.size()) replace(at, last, marks, is_before);
    }

    /// Puts the entry in place of the one at this index, and moves it to where it belongs.
    template <typename Before>
    void replace(std::size_t at, const Entry entry, EntryMarks& marks, Before&& is_before) {
        if (at > 0 && comes_first(entry, entries_[(at - 1) / 4], is_before))
            rise(at, entry, marks, is_before);
        else
            sink(at, entry, marks, is_before);
    }

  private:
    template <typename Before>
    static bool comes_first(const Entry& a, const Entry& b, Before&& is_before) {
        return a.time < b.time || (a.time == b.time && is_before(a.ball, b.ball));
    }

    template <typename Before>
    void rise(std::size_t at, const Entry entry, EntryMarks& marks, Before&& is_before) {
        while (at > 0) {
            const std::size_t above = (at - 1) / 4;
            if (!comes_first(entry, entries_[above], is_before)) break;
            put(entries_[above], at, marks);
            at = above;
        }
        put(entry, at, marks);
    }

    template <typename Before>
    void sink(std::size_t at, const Entry entry, EntryMarks& marks, Before&& is_before) {
        for (;;) {
            const std::size_t begin = 4 * at + 1;
            if (begin >= entries_.size()) break;
            const std::size_t end = begin + 4 < entries_.size() ? begin + 4 : entries_.size();
            std::size_t least = begin;
            for (std::size_t below = begin + 1; below < end; ++below)
                if (comes_first(entries_[below], entries_[least], is_before)) least = below;
            if (!comes_first(entries_[least], entry, is_before)) break;
            put(entries_[least], at, marks);
            at = least;
        }
        put(entry, at, marks);
    }

    void put(const Entry& entry, std::size_t at, EntryMarks& marks) {
        entries_[at] = entry;
        marks.put_in_heap(entry.ball, at);
    }

    std::vector<Entry> entries_;
};

}  // namespace carom
