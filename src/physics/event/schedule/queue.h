#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/event/schedule/bin_lists.h"
#include "physics/event/schedule/buckets.h"
#include "physics/event/schedule/entry_marks.h"
#include "physics/event/schedule/event_heap.h"
#include "physics/event/schedule/prefetch_cursor.h"
#include "physics/event/schedule/time_bins.h"

/// The event queue: a priority queue of balls by the time of their next events, each of which can
/// be replaced. O(1) an operation, however many balls there are.
///
/// A ladder queue. Time is divided into bins of equal width (time_bins.h):
///
///   present bin, and before     a heap of few entries (event_heap.h)
///   next bins                   an unordered list each (bin_lists.h)
///   bins after those, in groups a bucket (buckets.h) each group, emptied into lists when its turn
///                               is near: lists for all bins would not stay in the cache
///   further ahead               one more bucket, sorted through after every half round
///
/// The width of a bin follows the events, about three a bin. It changes nothing but the cost: the
/// caller decides which of two events at the same time comes first, by a total order.
///
/// Outside of the heap, a replaced entry stays where it is. Its generation is outdated
/// (entry_marks.h), so it is skipped when its turn comes; should there be too many, all are
/// removed.
///
/// Sources: Paul, A complexity O(1) priority queue for event driven molecular dynamics simulations,
/// Journal of Computational Physics 221, 2007; Tang, Goh and Thng, Ladder queue: an O(1) priority
/// queue structure for large-scale discrete event simulation, ACM Transactions on Modeling and
/// Computer Simulation 15, 2005.
namespace carom {

class EventQueue {
  public:
    static constexpr double never = std::numeric_limits<double>::infinity();

    /// Starts anew with balls 0..count-1. `time_of(ball)`: the time of its event, s, or `never`.
    /// `is_before`: see `first`. Cost: O(count).
    template <typename Time, typename Before>
    void build(std::size_t count, Time&& time_of, Before&& is_before) {
        heap_.clear();
        marks_.reset(count);
        moved_.clear();
        moved_.reserve(count);
        for (std::uint32_t ball = 0; ball < count; ++ball) {
            const double time = time_of(ball);
            if (time < never) moved_.push_back({time, ball, 0});
        }
        bins_.reset();
        arrange();
        take_present(is_before);
    }

    /// The ball whose event comes first; nothing if no ball has one. `is_before(a, b)`: whether
    /// ball a's event comes before ball b's, in a total order that goes by time first.
    template <typename Before>
    [[gnu::always_inline]] std::optional<std::uint32_t> first(Before&& is_before) {
        while (heap_.is_empty())
            if (!advance(is_before)) return std::nullopt;
        return heap_.first().ball;
    }

    /// A ball whose event comes some bins after the present one, for prefetching what its event
    /// needs; see PrefetchCursor::next.
    std::optional<std::uint32_t> next_to_prefetch() {
        const std::optional<std::uint32_t> ball = cursor_.next(bins_, lists_, marks_);
        if (ball) prefetch(*ball);
        return ball;
    }
    /// Prefetches the queue's record of the ball.
    void prefetch(std::uint32_t ball) const { marks_.prefetch(ball); }

    /// Replaces the event of `ball` by one at `time`, or `never`.
    template <typename Before>
    void update(std::uint32_t ball, double time, Before&& is_before) {
        const bool is_present = bins_.is_present(bins_.at(time));
        if (marks_.is_in_heap(ball)) {
            const std::uint32_t at = marks_.heap_index(ball);
            if (is_present) {
                heap_.replace(at, {time, ball}, marks_, is_before);
                return;
            }
            heap_.remove(at, marks_, is_before);
        }
        marks_.remove(ball);
        if (is_present)
            heap_.add({time, ball}, marks_, is_before);
        else if (time < never)
            keep(ball, time);
    }

  private:
    std::size_t bucket_of_group(std::uint64_t group) const {
        return static_cast<std::size_t>(group & (bins_.groups() - 1));
    }
    std::size_t far() const { return bins_.groups(); }
    // The number of entries in lists and in buckets of groups, void ones included.
    std::size_t near() const { return lists_.size() + buckets_.size() - far_kept_; }

    // Goes to the next bin with entries, or to the next group, and takes its entries into the heap.
    // False: no ball has an event.
    template <typename Before>
    [[gnu::noinline]] bool advance(Before&& is_before) {
        if (near() == 0) {
            collect();
            arrange();
            if (near() == 0) return false;
        } else {
            const std::uint64_t border = bins_.next_group();
            bins_.go_to(lists_.filled_from(bins_.present() + 1, border));
            buckets_.prefetch_more([this](std::uint32_t ball) {
                if (ball < marks_.size()) prefetch(ball);
            });
            if (bins_.present() == border) begin_group();
        }
        take_present(is_before);
        return true;
    }

    // Takes the list of the present bin into the heap.
    template <typename Before>
    void take_present(Before&& is_before) {
        lists_.empty(bins_.present(), [&](const QueuedEvent& event) {
            if (!marks_.is_valid(event)) return;
            ++taken_;
            heap_.add({event.time, event.ball}, marks_, is_before);
        });
    }

    // The present bin is the first of a group: empties the bucket of the next group into lists, and
    // every half round of the groups the bucket of far events.
    void begin_group() {
        const std::uint64_t group = bins_.begin_group();
        const auto keep_if_valid = [this](const QueuedEvent& event) {
            if (marks_.is_valid(event)) put_in(event);
        };
        buckets_.empty(bucket_of_group(group + 1), keep_if_valid);
        buckets_.prefetch_soon(bucket_of_group(group + 2));
        const std::uint64_t half = bins_.groups() / 2;
        if ((group & (half - 1)) != 0) return;
        const std::uint64_t passed = half * bins_.bins_a_group();
        const bool is_width_right = taken_ >= passed / 8 && taken_ <= 8 * passed;
        const std::size_t kept = lists_.size() + buckets_.size();
        const bool is_length_right = kept <= 4 * bins_.count() && kept >= bins_.count() / 16;
        taken_ = 0;
        if (!is_width_right || (!is_length_right && bins_.count() > TimeBins::least_count)) {
            collect();
            return arrange();
        }
        far_kept_ = 0;
        buckets_.empty(far(), keep_if_valid);
    }

    // Moves all valid entries outside of the heap into `moved_`.
    void collect() {
        moved_.clear();
        const auto keep_if_valid = [this](const QueuedEvent& event) {
            if (marks_.is_valid(event)) moved_.push_back(event);
        };
        for (std::uint64_t bin = bins_.present(); bin < bins_.lists_end(); ++bin)
            lists_.for_each(bin, keep_if_valid);
        for (std::size_t bucket = 0; bucket <= far(); ++bucket)
            buckets_.empty(bucket, keep_if_valid);
    }

    // Chooses bins by the events in `moved_`, from the first of them on. Pre: the heap is empty,
    // and `moved_` has all entries.
    void arrange() {
        bins_.choose(moved_);
        taken_ = 0;
        keep_moved();
    }

    // Puts the entries of `moved_`, and nothing else, into lists and buckets.
    void keep_moved() {
        most_kept_ = marks_.size() + marks_.size() / 2 + 64;
        lists_.reset(static_cast<std::size_t>(2 * bins_.bins_a_group()),
                     std::min<std::size_t>(most_kept_, 2 * TimeBins::most_listed));
        cursor_.reset();
        buckets_.reset(bins_.groups() + 1, most_kept_);
        far_kept_ = 0;
        marks_.restart_generations();
        for (QueuedEvent event : moved_) {
            event.generation = marks_.next_generation(event.ball);
            put_in(event);
        }
    }

    void keep(std::uint32_t ball, double time) {
        if (lists_.size() + buckets_.size() == most_kept_ || marks_.is_used_up()) {
            collect();
            keep_moved();
        }
        put_in({time, ball, marks_.next_generation(ball)});
    }

    // Puts an entry into a list or a bucket; one before the present bin into the present list. By
    // value, in registers: reading whole what was just written in parts would stall.
    void put_in(QueuedEvent event) {
        const double bin = bins_.at(event.time);
        if (bins_.is_far(bin)) {
            ++far_kept_;
            return buckets_.add(far(), event);
        }
        const std::uint64_t whole = bins_.whole(bin);
        if (whole < bins_.lists_end())
            lists_.add(whole, event);
        else
            buckets_.add(bucket_of_group(bins_.group_of(whole)), event);
    }

    TimeBins bins_;
    BinLists lists_;
    EventBuckets buckets_;  ///< group i has bucket i mod groups; far events the last
    EventHeap heap_;
    EntryMarks marks_;
    PrefetchCursor cursor_;
    std::vector<QueuedEvent> moved_;  ///< on their way from bins to others
    std::size_t far_kept_ = 0;        ///< in the bucket of far events, void ones included
    std::size_t most_kept_ = 0;       ///< capacity of lists and buckets
    std::size_t taken_ = 0;           ///< into the heap, since far events were sorted through
};

}  // namespace carom
