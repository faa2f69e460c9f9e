#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/event/schedule/buckets.h"

namespace carom {

/// How the event queue divides time: into bins of equal width, and bins into groups of equal
/// length. Bins are numbered from the first event on.
///
///   present bin, and before     the heap
///   up to lists_end()           the rest of the present group, and the next one: a list a bin
///   up to buckets_end()         a bucket a group
///   further ahead               one bucket more
///
/// Every operation but `choose` is O(1).
class TimeBins {
  public:
    static constexpr std::uint32_t least_count = 64;    ///< bins
    static constexpr std::uint32_t most_listed = 4096;  ///< bins, up to which all have lists

    /// Forgets how many bins there were. Otherwise `choose` changes their number only where it is
    /// far off.
    void reset() { count_ = least_count; }

    /// Chooses number, width and origin by these events, and makes the first bin the present one.
    /// Reorders the events. Cost: O(events).
    void choose(std::vector<QueuedEvent>& events) {
        while (count_ < events.size() && count_ < (1u << 30))
            count_ *= 2;
        while (count_ > least_count && count_ / 8 > events.size())
            count_ /= 2;
        const std::uint32_t in_group = count_ <= most_listed ? count_ : usual_group;
        group_bits_ = std::countr_zero(in_group);
        groups_ = std::max(count_ / in_group, 2u);
        present_ = 0;
        reach_from(0);
        if (events.empty()) return;
        const auto is_earlier = [](const QueuedEvent& a, const QueuedEvent& b) {
            return a.time < b.time;
        };
        const auto middle = events.begin() + static_cast<std::ptrdiff_t>(events.size() / 2);
        std::nth_element(events.begin(), middle, events.end(), is_earlier);
        origin_ = std::min_element(events.begin(), middle + 1, is_earlier)->time;
        // If n balls have events at rate 1 each, by the median time ln 2, the next of all comes
        // within 1 / n: about three a bin.
        const double width = (middle->time - origin_) * 4.0 / static_cast<double>(events.size());
        bins_a_second_ = width > 1e-300 ? 1.0 / width : 1.0;
    }

    /// Within reach, about as many as there are events; a power of two.
    std::uint32_t count() const { return count_; }
    std::uint64_t bins_a_group() const { return std::uint64_t{1} << group_bits_; }
    /// A power of two.
    std::uint32_t groups() const { return groups_; }

    std::uint64_t present() const { return present_; }
    std::uint64_t lists_end() const { return lists_end_; }
    /// The first bin of the group after the present one.
    std::uint64_t next_group() const { return lists_end_ - bins_a_group(); }
    void go_to(std::uint64_t bin) { present_ = bin; }
    /// The present bin is the first of a group: the reach moves on. Returns the group's number.
    std::uint64_t begin_group() {
        const std::uint64_t group = present_ >> group_bits_;
        reach_from(group);
        return group;
    }

    /// The bin of a time, s: not rounded, and before bin 0 negative.
    double at(double time) const { return (time - origin_) * bins_a_second_; }
    /// Whether the bin is the present one or before it. Signed, which processors convert faster.
    bool is_present(double bin) const {
        return bin < static_cast<double>(static_cast<std::int64_t>(present_) + 1);
    }
    /// Whether the bin has neither a list nor its group a bucket.
    bool is_far(double bin) const {
        return !(bin < static_cast<double>(static_cast<std::int64_t>(buckets_end_)));
    }
    /// The bin in whole, no earlier than the present one. Pre: !is_far(bin).
    std::uint64_t whole(double bin) const {
        return static_cast<std::uint64_t>(
            std::max(static_cast<std::int64_t>(bin), static_cast<std::int64_t>(present_)));
    }
    std::uint64_t group_of(std::uint64_t bin) const { return bin >> group_bits_; }

  private:
    static constexpr std::uint32_t usual_group = 128;  ///< bins, where not all have lists

    void reach_from(std::uint64_t group) {
        lists_end_ = (group + 2) << group_bits_;
        buckets_end_ = (group + groups_) << group_bits_;
    }

    double origin_ = 0.0;  ///< where bin 0 begins, s
    double bins_a_second_ = 1.0;
    std::uint64_t present_ = 0;
    std::uint64_t lists_end_ = 0;    ///< the first bin without a list
    std::uint64_t buckets_end_ = 0;  ///< the first without a bucket
    std::uint32_t count_ = least_count;
    int group_bits_ = 0;  ///< bins a group: 2^group_bits_
    std::uint32_t groups_ = 0;
};

}  // namespace carom
