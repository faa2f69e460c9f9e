#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/event/buckets.h"
#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

/// The event queue: the balls by the time of their next events, each of which can be replaced.
///
/// Time is cut into slices of equal width. The balls whose events are in the present slice, or
/// before, stand in a heap; there are few. Those of the slices that come next stand in a list for
/// each slice, in no order, so that it costs the same however many balls there are. The slices
/// after those come in blocks, with a bag (event_bags.h) for each block, which is emptied into the
/// lists when its turn is near: with many balls, lists for all slices would not stay in the cache.
/// Those further ahead are in one more bag, that is gone through now and then. The width follows
/// the events, about three a slice, and changes nothing but the cost: who comes first at the same
/// time is asked, and the order is total. (After Paul, A complexity O(1) priority queue for event
/// driven molecular dynamics simulations, Journal of Computational Physics 221, 2007, and Tang, Goh
/// and Thng, Ladder queue: an O(1) priority queue structure for large-scale discrete event
/// simulation, ACM Transactions on Modeling and Computer Simulation 15, 2005.)
///
/// Outside of the heap, what has been replaced stays where it is until its turn comes, and is
/// passed over then; should there be too much of it, all of it is thrown out.
namespace carom {

class EventQueue {
  public:
    static constexpr double never = std::numeric_limits<double>::infinity();

    /// Balls 0..count-1. `time_of(ball)`: of its event, s, or `never`. `is_before`: see `first`.
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
        slices_ = least_slices;
        arrange();
        take_present(is_before);
    }

    /// Whose event comes first; nothing if no ball has one. `is_before(a, b)`: whether ball a's
    /// event comes before ball b's, a total order that goes by time first.
    template <typename Before>
    [[gnu::always_inline]] std::optional<std::uint32_t> first(Before&& is_before) {
        while (heap_.empty())
            if (!advance(is_before)) return std::nullopt;
        return heap_.front().ball;
    }

    /// A ball whose event comes some slices after the present one: each of them about once, in
    /// about their order; nothing if there is none that far ahead. What is told so may be out of
    /// date a moment later: it is for fetching memory before it is needed.
    std::optional<std::uint32_t> scout() {
        std::uint32_t node = scout_ != none ? valid_from(nodes_[scout_].next) : none;
        if (scouted_ < present_ + least_lead) {
            scouted_ = present_ + least_lead;
            node = valid_from(heads_[list_of_slice(scouted_)]);
        }
        if (node == none && scouted_ < present_ + most_lead) {
            scouted_ = filled_from(scouted_ + 1, present_ + most_lead);
            node = valid_from(heads_[list_of_slice(scouted_)]);
        }
        scout_ = node;
        if (node == none) return std::nullopt;
        const std::uint32_t ball = nodes_[node].event.ball;
        fetch(ball);
        return ball;
    }
    /// What stands here about the ball, into the cache.
    void fetch(std::uint32_t ball) const { fetch_early(&marks_[ball]); }

    /// The event of `ball` has changed, and is at `time` now, or `never`.
    template <typename Before>
    void update(std::uint32_t ball, double time, Before&& is_before) {
        const std::uint32_t mark = marks_[ball];
        // Signed, which processors convert faster.
        const bool is_present =
            slice_of(time) < static_cast<double>(static_cast<std::int64_t>(present_) + 1);
        if ((mark & in_heap) != 0) {
            const std::uint32_t at = mark & ~in_heap;
            if (is_present) {
                settle(at, {time, ball}, is_before);
                return;
            }
            leave_heap(at, is_before);
        }
        // Whatever of it stands in a list or a bag is void now.
        marks_[ball] = unlisted;
        if (is_present)
            enter_heap({time, ball}, is_before);
        else if (time < never)
            keep(ball, time);
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr std::uint32_t least_slices = 64;
    static constexpr std::uint32_t most_listed = 4096;    ///< slices, up to which all are lists
    static constexpr std::uint32_t slices_a_block = 128;  ///< where not
    static constexpr std::uint32_t least_lead = 3;        ///< of `scout`, slices
    static constexpr std::uint32_t most_lead = 10;

    /// A ball's mark is its place in the heap with `in_heap`, or the stamp of its event.
    static constexpr std::uint32_t in_heap = 1u << 31;
    static constexpr std::uint32_t unlisted = 0;
    static constexpr std::uint32_t last_stamp = in_heap - 1;

    struct Entry {
        double time = 0.0;
        std::uint32_t ball = 0;
    };
    /// One in a list, or in none.
    struct Node {
        QueuedEvent event;
        std::uint32_t next = none;
    };

    bool is_valid(const QueuedEvent& event) const { return marks_[event.ball] == event.stamp; }
    // The first in the list, from that node on, that counts.
    std::uint32_t valid_from(std::uint32_t node) const {
        while (node != none && !is_valid(nodes_[node].event))
            node = nodes_[node].next;
        return node;
    }
    std::uint64_t block_slices() const { return std::uint64_t{1} << block_bits_; }
    double slice_of(double time) const { return (time - origin_) * slices_a_second_; }
    std::uint32_t list_of_slice(std::uint64_t slice) const {
        return static_cast<std::uint32_t>(slice & (heads_.size() - 1));
    }
    std::size_t bag_of_block(std::uint64_t block) const {
        return static_cast<std::size_t>(block & (blocks_ - 1));
    }
    std::size_t far() const { return blocks_; }
    // How many are in lists and in bags of blocks, void ones too.
    std::size_t near() const { return listed_ + bags_.size() - far_kept_; }

    // The first slice before `end` that has somebody, from `slice` on; or `end`. Pre: all of them
    // have lists.
    std::uint64_t filled_from(std::uint64_t slice, std::uint64_t end) const {
        while (slice < end) {
            const std::uint32_t list = list_of_slice(slice);
            const std::uint64_t bits = is_filled_[list / 64] >> (list % 64);
            if (bits != 0)
                return std::min(slice + static_cast<std::uint64_t>(std::countr_zero(bits)), end);
            slice += 64 - list % 64;
        }
        return end;
    }

    // Up to where there are lists, and bags of blocks.
    void reach_from(std::uint64_t block) {
        lists_end_ = (block + 2) << block_bits_;
        bags_end_ = (block + blocks_) << block_bits_;
    }

    // To the next slice that has somebody, or to the next block: what is in it goes into the heap.
    // False: no ball has an event.
    template <typename Before>
    [[gnu::noinline]] bool advance(Before&& is_before) {
        if (near() == 0) {
            collect();
            arrange();
            if (near() == 0) return false;
        } else {
            const std::uint64_t border = lists_end_ - block_slices();
            present_ = filled_from(present_ + 1, border);
            bags_.fetch_more([this](std::uint32_t ball) {
                if (ball < marks_.size()) fetch(ball);
            });
            if (present_ == border) begin_block();
        }
        take_present(is_before);
        return true;
    }

    // What is in the list of the present slice goes into the heap.
    template <typename Before>
    void take_present(Before&& is_before) {
        const std::uint32_t list = list_of_slice(present_);
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

    // The present slice is the first of a block: lists for the next one too. Every half round of
    // the blocks, those of the far events that are within reach now.
    void begin_block() {
        const std::uint64_t block = present_ >> block_bits_;
        reach_from(block);
        const auto keep_if_valid = [this](const QueuedEvent& event) {
            if (is_valid(event)) put_in(event);
        };
        bags_.empty(bag_of_block(block + 1), keep_if_valid);
        bags_.fetch_soon(bag_of_block(block + 2));
        const std::uint64_t half = blocks_ / 2;
        if ((block & (half - 1)) != 0) return;
        const std::uint64_t passed = half << block_bits_;
        const bool is_width_right = taken_ >= passed / 8 && taken_ <= 8 * passed;
        const std::size_t kept = listed_ + bags_.size();
        const bool is_length_right = kept <= 4 * slices_ && kept >= slices_ / 16;
        taken_ = 0;
        if (!is_width_right || (!is_length_right && slices_ > least_slices)) {
            collect();
            return arrange();
        }
        far_kept_ = 0;
        bags_.empty(far(), keep_if_valid);
    }

    // All events outside of the heap that count.
    void collect() {
        moved_.clear();
        const auto keep_if_valid = [this](const QueuedEvent& event) {
            if (is_valid(event)) moved_.push_back(event);
        };
        for (std::uint64_t slice = present_; slice < lists_end_; ++slice)
            for (std::uint32_t node = heads_[list_of_slice(slice)]; node != none;
                 node = nodes_[node].next)
                keep_if_valid(nodes_[node].event);
        for (std::size_t bag = 0; bag <= far(); ++bag)
            bags_.empty(bag, keep_if_valid);
    }

    // Slices as the events are now, from the first of them on. Pre: the heap is empty, and
    // `moved_` are all.
    void arrange() {
        while (slices_ < moved_.size() && slices_ < (1u << 30))
            slices_ *= 2;
        while (slices_ > least_slices && slices_ / 8 > moved_.size())
            slices_ /= 2;
        const std::uint32_t in_block = slices_ <= most_listed ? slices_ : slices_a_block;
        block_bits_ = std::countr_zero(in_block);
        blocks_ = std::max(slices_ / in_block, 2u);
        present_ = taken_ = 0;
        reach_from(0);
        if (!moved_.empty()) {
            const auto is_earlier = [](const QueuedEvent& a, const QueuedEvent& b) {
                return a.time < b.time;
            };
            const auto middle = moved_.begin() + static_cast<std::ptrdiff_t>(moved_.size() / 2);
            std::nth_element(moved_.begin(), middle, moved_.end(), is_earlier);
            origin_ = std::min_element(moved_.begin(), middle + 1, is_earlier)->time;
            // The first event of each of n is about to be the first of all once in
            // middle / (n ln 2).
            const double width =
                (middle->time - origin_) * 4.0 / static_cast<double>(moved_.size());
            slices_a_second_ = width > 1e-300 ? 1.0 / width : 1.0;
        }
        keep_moved();
    }

    // Puts those of `moved_`, and nothing else, where they belong.
    void keep_moved() {
        const auto lists = static_cast<std::size_t>(2 * block_slices());
        heads_.assign(lists, none);
        is_filled_.assign(lists / 64, 0);
        nodes_.clear();
        free_node_ = scout_ = none;
        scouted_ = 0;
        most_kept_ = marks_.size() + marks_.size() / 2 + 64;
        nodes_.reserve(std::min<std::size_t>(most_kept_, 2 * most_listed));
        bags_.reset(blocks_ + 1, most_kept_);
        far_kept_ = listed_ = 0;
        stamp_ = unlisted;
        for (QueuedEvent event : moved_) {
            event.stamp = marks_[event.ball] = ++stamp_;
            put_in(event);
        }
    }

    void keep(std::uint32_t ball, double time) {
        if (listed_ + bags_.size() == most_kept_ || stamp_ == last_stamp) {
            collect();
            keep_moved();
        }
        marks_[ball] = ++stamp_;
        put_in({time, ball, stamp_});
    }

    // Into a list, or a bag. What comes before the present slice is in its list. By value, in
    // registers: what has been written to memory in parts takes long to be read as a whole.
    void put_in(QueuedEvent event) {
        const double slice = slice_of(event.time);
        if (!(slice < static_cast<double>(static_cast<std::int64_t>(bags_end_)))) {
            ++far_kept_;
            return bags_.add(far(), event);
        }
        const auto whole =
            std::max(static_cast<std::int64_t>(slice), static_cast<std::int64_t>(present_));
        const auto place = static_cast<std::uint64_t>(whole);
        if (place < lists_end_)
            enlist(event, list_of_slice(place));
        else
            bags_.add(bag_of_block(place >> block_bits_), event);
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
    // Seldom: they are used again.
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
        if (at < heap_.size()) settle(at, last, is_before);
    }

    template <typename Before>
    static bool comes_first(const Entry& a, const Entry& b, Before&& is_before) {
        return a.time < b.time || (a.time == b.time && is_before(a.ball, b.ball));
    }

    // Puts the entry where it belongs, `at` being free.
    template <typename Before>
    void settle(std::size_t at, const Entry entry, Before&& is_before) {
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

    double origin_ = 0.0;  ///< where slice 0 begins, s
    double slices_a_second_ = 1.0;
    std::uint64_t present_ = 0;
    std::uint64_t lists_end_ = 0;          ///< the first slice that has no list
    std::uint64_t bags_end_ = 0;           ///< the first that has no bag either
    std::uint32_t slices_ = least_slices;  ///< within reach, about; a power of two, as the next two
    int block_bits_ = 0;                   ///< slices a block: 2^block_bits_
    std::uint32_t blocks_ = 0;
    std::uint32_t stamp_ = unlisted;    ///< the last
    std::size_t listed_ = 0;            ///< in lists, void ones too
    std::size_t far_kept_ = 0;          ///< in the bag of the far, void ones too
    std::size_t most_kept_ = 0;         ///< in all lists and bags
    std::size_t taken_ = 0;             ///< into the heap, since the far were looked at
    std::uint64_t scouted_ = 0;         ///< the slice in which `scout` is
    std::uint32_t scout_ = none;        ///< the node that it told last
    std::uint32_t free_node_ = none;    ///< the first in no list, the others behind it
    std::vector<std::uint32_t> heads_;  ///< first nodes of the lists: slice i has list i mod size
    std::vector<std::uint64_t> is_filled_;  ///< a bit for each of the lists
    std::vector<Node> nodes_;
    EventBags bags_;                    ///< of the blocks, block i mod blocks_; of the far
    LargeVector<std::uint32_t> marks_;  ///< by ball
    std::vector<Entry> heap_;           ///< each above four
    std::vector<QueuedEvent> moved_;
};

}  // namespace carom
