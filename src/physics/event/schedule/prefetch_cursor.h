#pragma once

#include <cstdint>
#include <optional>

#include "physics/event/schedule/bin_lists.h"
#include "physics/event/schedule/entry_marks.h"
#include "physics/event/schedule/time_bins.h"

namespace carom {

/// A place in the event queue that runs some bins ahead of the present one, for prefetching what
/// the events there need. It changes nothing.
class PrefetchCursor {
  public:
    /// The lists have been made anew.
    void reset() {
        node_ = BinLists::no_node;
        bin_ = 0;
    }

    /// The next ball: each about once, in about the order of time; nothing if there is none that
    /// far ahead. The answer may be out of date a moment later. Cost: O(1), on average.
    std::optional<std::uint32_t> next(const TimeBins& bins, const BinLists& lists,
                                      const EntryMarks& marks) {
        std::uint32_t node =
            node_ != BinLists::no_node ? lists.next_valid(node_, marks) : BinLists::no_node;
        if (bin_ < bins.present() + least_lead) {
            bin_ = bins.present() + least_lead;
            node = lists.first_valid(bin_, marks);
        }
        if (node == BinLists::no_node && bin_ < bins.present() + most_lead) {
            bin_ = lists.filled_from(bin_ + 1, bins.present() + most_lead);
            node = lists.first_valid(bin_, marks);
        }
        node_ = node;
        if (node == BinLists::no_node) return std::nullopt;
        return lists.ball(node);
    }

  private:
    static constexpr std::uint32_t least_lead = 3;  ///< bins
    static constexpr std::uint32_t most_lead = 10;

    std::uint64_t bin_ = 0;
    std::uint32_t node_ = BinLists::no_node;
};

}  // namespace carom
