#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/event/schedule/buckets.h"
#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

/// The event queue: a priority queue of balls by the time of their next events, each of which can
/// be replaced. O(1) an operation, however many balls there are.
///
/// A ladder queue. Time is divided into bins of equal width:
///
///   present bin, and before     a heap of few entries
///   next bins                   an unordered list each
///   bins after those, in groups a bucket (buckets.h) each group, emptied into lists when its turn
///                               is near: lists for all bins would not stay in the cache
///   further ahead               one more bucket, sorted through after every half round
///
/// The width of a bin follows the events, about three a bin. It changes nothing but the cost: the
/// caller decides which of two events at the same time comes first, by a total order.
///
/// Outside of the heap, a replaced entry stays where it is. Its generation is outdated, so it is
/// skipped when its turn comes; should there be too many, all are removed.
///
/// One class in one file, though a long one: heap, lists and buckets share the marks of the balls,
/// and every move between them is inlined.
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
        marks_.assign(count, unlisted);
        moved_.clear();
        moved_.reserve(count);
        for (std::uint32_t ball = 0; ball < count; ++ball) {
            const double time = time_of(ball);
            if (time < never) moved_.push_back({time, ball, 0});
        }
        bins_ = least_bins;
        arrange();
        take_present(is_before);
    }

    /// The ball whose event comes first; nothing if no ball has one. `is_before(a, b)`: whether
    /// ball a's event comes before ball b's, in a total order that goes by time first.
    template <typename Before>
    [[gnu::always_inline]] std::optional<std::uint32_t> first(Before&& is_before) {
        while (heap_.empty())
            if (!advance(is_before)) return std::nullopt;
        return heap_.front().ball;
    }

    /// A ball whose event comes some bins after the present one, for prefetching what its event
    /// needs: each ball about once, in about the order of time; nothing if there is none that far
    /// ahead. The answer may be out of date a moment later.
    std::optional<std::uint32_t> next_to_prefetch() {
        std::uint32_t node = cursor_ != none ? valid_from(nodes_[cursor_].next) : none;
        if (cursor_bin_ < present_ + least_lead) {
            cursor_bin_ = present_ + least_lead;
            node = valid_from(heads_[list_of_bin(cursor_bin_)]);
        }
        if (node == none && cursor_bin_ < present_ + most_lead) {
            cursor_bin_ = filled_from(cursor_bin_ + 1, present_ + most_lead);
            node = valid_from(heads_[list_of_bin(cursor_bin_)]);
        }
        cursor_ = node;
        if (node == none) return std::nullopt;
        const std::uint32_t ball = nodes_[node].event.ball;
        prefetch(ball);
        return ball;
    }
    /// Prefetches the queue's record of the ball.
    void prefetch(std::uint32_t ball) const { fetch_early(&marks_[ball]); }

    /// Replaces the event of `ball` by one at `time`, or `never`.
    template <typename Before>
    void update(std::uint32_t ball, double time, Before&& is_before) {
        const std::uint32_t mark = marks_[ball];
        // Signed, which processors convert faster.
        const bool is_present =
            bin_of(time) < static_cast<double>(static_cast<std::int64_t>(present_) + 1);
        if ((mark & in_heap) != 0) {
            const std::uint32_t at = mark & ~in_heap;
            if (is_present) {
                reposition(at, {time, ball}, is_before);
                return;
            }
            leave_heap(at, is_before);
        }
        // Entries of the ball in lists and buckets are void now.
        marks_[ball] = unlisted;
        if (is_present)
            enter_heap({time, ball}, is_before);
        else if (time < never)
            keep(ball, time);
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr std::uint32_t least_bins = 64;
    static constexpr std::uint32_t most_listed = 4096;  ///< bins, up to which all have lists
    static constexpr std::uint32_t bins_a_group = 128;  ///< where not
    static constexpr std::uint32_t least_lead = 3;      ///< of `next_to_prefetch`, bins
    static constexpr std::uint32_t most_lead = 10;

    /// A ball's mark is its index in the heap with `in_heap`, or the generation of its entry.
    static constexpr std::uint32_t in_heap = 1u << 31;
    static constexpr std::uint32_t unlisted = 0;
    static constexpr std::uint32_t last_generation = in_heap - 1;

    struct Entry {
        double time = 0.0;
        std::uint32_t ball = 0;
    };
    /// An entry of a list, or a free one.
    struct Node {
        QueuedEvent event;
        std::uint32_t next = none;
    };

    bool is_valid(const QueuedEvent& event) const { return marks_[event.ball] == event.generation; }
    // The first valid node of the list, from that one on.
    std::uint32_t valid_from(std::uint32_t node) const {
        while (node != none && !is_valid(nodes_[node].event))
            node = nodes_[node].next;
        return node;
    }
    std::uint64_t bins_of_group() const { return std::uint64_t{1} << group_bits_; }
    double bin_of(double time) const { return (time - origin_) * bins_a_second_; }
    std::uint32_t list_of_bin(std::uint64_t bin) const {
        return static_cast<std::uint32_t>(bin & (heads_.size() - 1));
    }
    std::size_t bucket_of_group(std::uint64_t group) const {
        return static_cast<std::size_t>(group & (groups_ - 1));
    }
    std::size_t far() const { return groups_; }
    // The number of entries in lists and in buckets of groups, void ones included.
    std::size_t near() const { return listed_ + buckets_.size() - far_kept_; }

    // The first bin in `bin`..`end` - 1 with entries; else `end`. Pre: all of them have lists.
    std::uint64_t filled_from(std::uint64_t bin, std::uint64_t end) const {
        while (bin < end) {
            const std::uint32_t list = list_of_bin(bin);
            const std::uint64_t bits = is_filled_[list / 64] >> (list % 64);
            if (bits != 0)
                return std::min(bin + static_cast<std::uint64_t>(std::countr_zero(bits)), end);
            bin += 64 - list % 64;
        }
        return end;
    }

    // Sets how far lists and buckets reach, with `group` the present group.
    void reach_from(std::uint64_t group) {
        lists_end_ = (group + 2) << group_bits_;
        buckets_end_ = (group + groups_) << group_bits_;
    }

    // Goes to the next bin with entries, or to the next group, and takes its entries into the heap.
    // False: no ball has an event.
    template <typename Before>
    [[gnu::noinline]] bool advance(Before&& is_before) {
        if (near() == 0) {
            collect();
            arrange();
            if (near() == 0) return false;
        } else {
            const std::uint64_t border = lists_end_ - bins_of_group();
            present_ = filled_from(present_ + 1, border);
            buckets_.prefetch_more([this](std::uint32_t ball) {
                if (ball < marks_.size()) prefetch(ball);
            });
            if (present_ == border) begin_group();
        }
        take_present(is_before);
        return true;
    }

    // Takes the list of the present bin into the heap.
    template <typename Before>
    void take_present(Before&& is_before) {
        const std::uint32_t list = list_of_bin(present_);
        std::uint32_t node = heads_[list];
        heads_[list] = none;
        is_filled_[list / 64] &= ~(std::uint64_t{1} << (list % 64));
        while (node != none) {
            const QueuedEvent event = nodes_[node].event;
            const std::uint32_t next = nodes_[node].next;
            nodes_[node].next = free_node_;
            free_node_ = node;
            node = next;
            --listed_;
            if (!is_valid(event)) continue;
            ++taken_;
            enter_heap({event.time, event.ball}, is_before);
        }
    }

    // The present bin is the first of a group: empties the bucket of the next group into lists, and
    // every half round of the groups the bucket of far events.
    void begin_group() {
        const std::uint64_t group = present_ >> group_bits_;
        reach_from(group);
        const auto keep_if_valid = [this](const QueuedEvent& event) {
            if (is_valid(event)) put_in(event);
        };
        buckets_.empty(bucket_of_group(group + 1), keep_if_valid);
        buckets_.prefetch_soon(bucket_of_group(group + 2));
        const std::uint64_t half = groups_ / 2;
        if ((group & (half - 1)) != 0) return;
        const std::uint64_t passed = half << group_bits_;
        const bool is_width_right = taken_ >= passed / 8 && taken_ <= 8 * passed;
        const std::size_t kept = listed_ + buckets_.size();
        const bool is_length_right = kept <= 4 * bins_ && kept >= bins_ / 16;
        taken_ = 0;
        if (!is_width_right || (!is_length_right && bins_ > least_bins)) {
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
            if (is_valid(event)) moved_.push_back(event);
        };
        for (std::uint64_t bin = present_; bin < lists_end_; ++bin)
            for (std::uint32_t node = heads_[list_of_bin(bin)]; node != none;
                 node = nodes_[node].next)
                keep_if_valid(nodes_[node].event);
        for (std::size_t bucket = 0; bucket <= far(); ++bucket)
            buckets_.empty(bucket, keep_if_valid);
    }

    // Chooses bins by the events in `moved_`, from the first of them on. Pre: the heap is empty,
    // and `moved_` has all entries.
    void arrange() {
        while (bins_ < moved_.size() && bins_ < (1u << 30))
            bins_ *= 2;
        while (bins_ > least_bins && bins_ / 8 > moved_.size())
            bins_ /= 2;
        const std::uint32_t in_group = bins_ <= most_listed ? bins_ : bins_a_group;
        group_bits_ = std::countr_zero(in_group);
        groups_ = std::max(bins_ / in_group, 2u);
        present_ = taken_ = 0;
        reach_from(0);
        if (!moved_.empty()) {
            const auto is_earlier = [](const QueuedEvent& a, const QueuedEvent& b) {
                return a.time < b.time;
            };
            const auto middle = moved_.begin() + static_cast<std::ptrdiff_t>(moved_.size() / 2);
            std::nth_element(moved_.begin(), middle, moved_.end(), is_earlier);
            origin_ = std::min_element(moved_.begin(), middle + 1, is_earlier)->time;
            // If n balls have events at rate 1 each, by the median time ln 2, the next of all comes
            // within 1 / n: about three a bin.
            const double width =
                (middle->time - origin_) * 4.0 / static_cast<double>(moved_.size());
            bins_a_second_ = width > 1e-300 ? 1.0 / width : 1.0;
        }
        keep_moved();
    }

    // Puts the entries of `moved_`, and nothing else, into lists and buckets.
    void keep_moved() {
        const auto lists = static_cast<std::size_t>(2 * bins_of_group());
        heads_.assign(lists, none);
        is_filled_.assign(lists / 64, 0);
        nodes_.clear();
        free_node_ = cursor_ = none;
        cursor_bin_ = 0;
        most_kept_ = marks_.size() + marks_.size() / 2 + 64;
        nodes_.reserve(std::min<std::size_t>(most_kept_, 2 * most_listed));
        buckets_.reset(groups_ + 1, most_kept_);
        far_kept_ = listed_ = 0;
        generation_ = unlisted;
        for (QueuedEvent event : moved_) {
            event.generation = marks_[event.ball] = ++generation_;
            put_in(event);
        }
    }

    void keep(std::uint32_t ball, double time) {
        if (listed_ + buckets_.size() == most_kept_ || generation_ == last_generation) {
            collect();
            keep_moved();
        }
        marks_[ball] = ++generation_;
        put_in({time, ball, generation_});
    }

    // Puts an entry into a list or a bucket; one before the present bin into the present list. By
    // value, in registers: reading whole what was just written in parts would stall.
    void put_in(QueuedEvent event) {
        const double bin = bin_of(event.time);
        if (!(bin < static_cast<double>(static_cast<std::int64_t>(buckets_end_)))) {
            ++far_kept_;
            return buckets_.add(far(), event);
        }
        const auto whole =
            std::max(static_cast<std::int64_t>(bin), static_cast<std::int64_t>(present_));
        const auto place = static_cast<std::uint64_t>(whole);
        if (place < lists_end_)
            enlist(event, list_of_bin(place));
        else
            buckets_.add(bucket_of_group(place >> group_bits_), event);
    }

    void enlist(QueuedEvent event, std::uint32_t list) {
        if (free_node_ == none) add_node();
        const std::uint32_t at = free_node_;
        Node& node = nodes_[at];
        free_node_ = node.next;
        node.event = event;
        node.next = heads_[list];
        heads_[list] = at;
        is_filled_[list / 64] |= std::uint64_t{1} << (list % 64);
        ++listed_;
    }
    // Rare: nodes are used again.
    [[gnu::noinline]] void add_node() {
        free_node_ = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({});
    }

    template <typename Before>
    void enter_heap(const Entry& entry, Before&& is_before) {
        heap_.push_back({});
        rise(heap_.size() - 1, entry, is_before);
    }

    template <typename Before>
    void leave_heap(std::size_t at, Before&& is_before) {
        const Entry last = heap_.back();
        heap_.pop_back();
        if (at < heap_.size()) reposition(at, last, is_before);
    }

    template <typename Before>
    static bool comes_first(const Entry& a, const Entry& b, Before&& is_before) {
        return a.time < b.time || (a.time == b.time && is_before(a.ball, b.ball));
    }

    // Puts the entry where it belongs in the heap, where `at` is free.
    template <typename Before>
    void reposition(std::size_t at, const Entry entry, Before&& is_before) {
        if (at > 0 && comes_first(entry, heap_[(at - 1) / 4], is_before))
            rise(at, entry, is_before);
        else
            sink(at, entry, is_before);
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
        marks_[entry.ball] = in_heap | static_cast<std::uint32_t>(at);
    }

    double origin_ = 0.0;  ///< where bin 0 begins, s
    double bins_a_second_ = 1.0;
    std::uint64_t present_ = 0;
    std::uint64_t lists_end_ = 0;      ///< the first bin without a list
    std::uint64_t buckets_end_ = 0;    ///< the first without a bucket
    std::uint32_t bins_ = least_bins;  ///< within reach; a power of two, as the next two
    int group_bits_ = 0;               ///< bins a group: 2^group_bits_
    std::uint32_t groups_ = 0;
    std::uint32_t generation_ = unlisted;   ///< the last
    std::size_t listed_ = 0;                ///< entries in lists, void ones included
    std::size_t far_kept_ = 0;              ///< in the bucket of far events, void ones included
    std::size_t most_kept_ = 0;             ///< capacity of lists and buckets
    std::size_t taken_ = 0;                 ///< into the heap, since far events were sorted through
    std::uint64_t cursor_bin_ = 0;          ///< the bin of the prefetch cursor
    std::uint32_t cursor_ = none;           ///< the node of the prefetch cursor
    std::uint32_t free_node_ = none;        ///< the first of the free nodes, a chain
    std::vector<std::uint32_t> heads_;      ///< first nodes of the lists: bin i has list i mod size
    std::vector<std::uint64_t> is_filled_;  ///< a bit for each of the lists
    std::vector<Node> nodes_;
    EventBuckets buckets_;              ///< group i has bucket i mod groups_; far events the last
    LargeVector<std::uint32_t> marks_;  ///< by ball
    std::vector<Entry> heap_;           ///< 4-ary
    std::vector<QueuedEvent> moved_;
};

}  // namespace carom
