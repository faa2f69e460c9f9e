#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/fetch.h"
#include "physics/large_pages.h"

/// The event queue: the balls by the time of their next events, each of which can be replaced.
///
/// Time is cut into slices of equal width. The balls whose events are in the present slice, or
/// before, stand in a heap; there are few. Those of the slices to come stand in a list for each
/// slice, in no order, so that to replace an event costs the same however many balls there are;
/// those further ahead than the lists reach, in one list that is gone through now and then. The
/// width follows the events, about three a slice, and changes nothing but the cost: who comes first
/// at the same time is asked, and the order is total. (After Paul, A complexity O(1) priority queue
/// for event driven molecular dynamics simulations, Journal of Computational Physics 221, 2007.)
namespace carom {

class EventQueue {
  public:
    static constexpr double never = std::numeric_limits<double>::infinity();

    /// Balls 0..count-1. `time_of(ball)`: of its event, s, or `never`. `is_before`: see `first`.
    template <typename Time, typename Before>
    void build(std::size_t count, Time&& time_of, Before&& is_before) {
        slices_ = least_slices;
        make_lists();
        heap_.clear();
        links_.resize(count + 1);
        listed_ = finite_ = 0;
        scout_ = none;
        for (std::uint32_t ball = 0; ball < count; ++ball) {
            links_[ball].time = time_of(ball);
            enlist(ball, links_[ball].time < never ? far() : no_time());
        }
        advance(is_before);
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
        std::uint32_t ball = none;
        if (scout_ != none && links_[scout_].list == list_of_slice(scouted_))
            ball = links_[scout_].next;
        if (scouted_ < present_ + least_lead) {
            scouted_ = present_ + least_lead;
            ball = heads_[list_of_slice(scouted_)];
        }
        if (ball == none && scouted_ < present_ + most_lead) {
            scouted_ = filled_from(scouted_ + 1, present_ + most_lead);
            ball = heads_[list_of_slice(scouted_)];
        }
        scout_ = ball;
        if (ball == none) return std::nullopt;
        fetch(ball);
        return ball;
    }
    /// What stands here about the ball, into the cache.
    void fetch(std::uint32_t ball) const { fetch_early(&links_[ball]); }

    /// The event of `ball` has changed, and is at `time` now, or `never`.
    template <typename Before>
    void update(std::uint32_t ball, double time, Before&& is_before) {
        const std::uint32_t old = links_[ball].list;
        const std::uint32_t list = list_for(time);
        links_[ball].time = time;
        if (old == in_heap && list == in_heap) {
            settle(links_[ball].next, {time, ball}, is_before);
            return;
        }
        if (old == in_heap)
            leave_heap(links_[ball].next, is_before);
        else
            unlink(ball);
        if (list == in_heap)
            enter_heap(ball, is_before);
        else
            enlist(ball, list);
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr std::uint32_t in_heap = none;
    static constexpr std::uint32_t least_slices = 64;
    static constexpr std::uint32_t least_lead = 3;  ///< of `scout`, slices
    static constexpr std::uint32_t most_lead = 10;

    struct Entry {
        double time = 0.0;
        std::uint32_t ball = 0;
    };
    struct Link {
        double time = 0.0;
        std::uint32_t next = none;  ///< in the same list; or the place in the heap
        std::uint32_t before = none;
        std::uint32_t list = in_heap;  ///< of heads_
    };

    std::uint32_t far() const { return slices_; }
    std::uint32_t no_time() const { return slices_ + 1; }
    std::uint32_t list_of_slice(std::uint64_t slice) const {
        return static_cast<std::uint32_t>(slice & (slices_ - 1));
    }

    // Where an event at that time belongs.
    std::uint32_t list_for(double time) const {
        // Signed, which processors convert faster; and nobody can foretell which of the lists.
        const double slice = (time - origin_) * slices_a_second_;
        const auto present = static_cast<std::int64_t>(present_);
        if (slice < static_cast<double>(present + 1)) return in_heap;
        const auto end = static_cast<double>(present + slices_);
        const auto whole =
            static_cast<std::uint64_t>(static_cast<std::int64_t>(std::min(end, slice)));
        return select(slice < end, list_of_slice(whole),
                      far() + static_cast<std::uint32_t>(!(time < never)));
    }

    // The first slice before `end` that has somebody, from `slice` on; or `end`.
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
    void note_emptied(std::uint32_t list) {
        const auto is_empty = static_cast<std::uint64_t>(heads_[list] == none);
        is_filled_[list / 64] &= ~(is_empty << (list % 64));
    }
    void make_lists() {
        heads_.assign(slices_ + 2, none);
        is_filled_.assign(slices_ / 64 + 1, 0);
    }

    // To the next slice that has somebody: what is in it goes into the heap. False: no ball has an
    // event.
    template <typename Before>
    [[gnu::noinline]] bool advance(Before&& is_before) {
        if (finite_ == 0) return false;
        if (listed_ == 0) {
            arrange();
        } else {
            const std::uint64_t half = slices_ / 2;
            const std::uint64_t rest = half - (present_ & (half - 1));
            present_ = filled_from(present_ + 1, present_ + rest);
            if ((present_ & (half - 1)) == 0) look_further();
        }
        const std::uint32_t list = list_of_slice(present_);
        std::uint32_t& head = heads_[list];
        std::size_t count = 0;
        for (std::uint32_t ball = head; ball != none; ++count) {
            const std::uint32_t next = links_[ball].next;
            enter_heap(ball, is_before);
            ball = next;
        }
        head = none;
        note_emptied(list);
        listed_ -= count;
        finite_ -= count;
        taken_ += count;
        return true;
    }

    // Every half round of the slices: those of the far events that the lists reach now.
    void look_further() {
        const bool is_width_right = taken_ >= slices_ / 16 && taken_ <= 4 * slices_;
        const bool is_length_right = finite_ <= 4 * slices_ && finite_ >= slices_ / 16;
        taken_ = 0;
        if (!is_width_right || (!is_length_right && slices_ > least_slices)) return arrange();
        for (std::uint32_t ball = heads_[far()]; ball != none;) {
            const std::uint32_t next = links_[ball].next;
            const std::uint32_t list = list_for(links_[ball].time);
            if (list != far()) {
                unlink(ball);
                enlist(ball, list == in_heap ? list_of_slice(present_) : list);
            }
            ball = next;
        }
    }

    // Slices as the events are now, from the first of them on. Pre: the heap is empty, and some
    // ball has an event.
    void arrange() {
        moved_.clear();
        for (std::uint32_t list = 0; list <= far(); ++list)
            for (std::uint32_t ball = heads_[list]; ball != none; ball = links_[ball].next)
                moved_.push_back(ball);
        const std::uint32_t timeless = heads_[no_time()];
        while (slices_ < moved_.size() && slices_ < (1u << 30))
            slices_ *= 2;
        while (slices_ > least_slices && slices_ / 8 > moved_.size())
            slices_ /= 2;
        make_lists();
        for (std::uint32_t ball = timeless; ball != none; ball = links_[ball].next)
            links_[ball].list = no_time();
        heads_[no_time()] = timeless;

        const auto is_earlier = [this](std::uint32_t a, std::uint32_t b) {
            return links_[a].time < links_[b].time;
        };
        const auto middle = moved_.begin() + static_cast<std::ptrdiff_t>(moved_.size() / 2);
        std::nth_element(moved_.begin(), middle, moved_.end(), is_earlier);
        origin_ = links_[*std::min_element(moved_.begin(), middle + 1, is_earlier)].time;
        // The first event of each of n is about to be the first of all once in middle / (n ln 2).
        const double width =
            (links_[*middle].time - origin_) * 4.0 / static_cast<double>(moved_.size());
        slices_a_second_ = width > 1e-300 ? 1.0 / width : 1.0;
        present_ = taken_ = 0;
        scouted_ = 0;
        scout_ = none;
        listed_ = finite_ = 0;
        for (const std::uint32_t ball : moved_) {
            const std::uint32_t list = list_for(links_[ball].time);
            enlist(ball, list == in_heap ? 0 : list);
        }
    }

    // Or, in place of nobody, one link more than there are balls, to write to.
    std::uint32_t somebody(std::uint32_t ball) const {
        return std::min(ball, static_cast<std::uint32_t>(links_.size() - 1));
    }

    void enlist(std::uint32_t ball, std::uint32_t list) {
        const std::uint32_t next = heads_[list];
        links_[ball] = {links_[ball].time, next, none, list};
        links_[somebody(next)].before = ball;
        heads_[list] = ball;
        is_filled_[list / 64] |= std::uint64_t{1} << (list % 64);
        listed_ += list < far();
        finite_ += list < no_time();
    }

    void unlink(std::uint32_t ball) {
        const Link link = links_[ball];
        if (link.before == none)
            heads_[link.list] = link.next;
        else
            links_[link.before].next = link.next;
        links_[somebody(link.next)].before = link.before;
        note_emptied(link.list);
        listed_ -= link.list < far();
        finite_ -= link.list < no_time();
    }

    template <typename Before>
    void enter_heap(std::uint32_t ball, Before&& is_before) {
        links_[ball].list = in_heap;
        heap_.push_back({});
        rise(heap_.size() - 1, {links_[ball].time, ball}, is_before);
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
        links_[entry.ball].next = static_cast<std::uint32_t>(at);
    }

    double origin_ = 0.0;  ///< where slice 0 begins, s
    double slices_a_second_ = 1.0;
    std::uint64_t present_ = 0;
    std::uint32_t slices_ =
        least_slices;                   ///< lists, a power of two; slice i is in list i mod slices_
    std::size_t listed_ = 0;            ///< in lists of slices
    std::size_t finite_ = 0;            ///< the same, and far ones
    std::size_t taken_ = 0;             ///< into the heap, since `look_further`
    std::uint64_t scouted_ = 0;         ///< the slice in which `scout` is
    std::uint32_t scout_ = none;        ///< whom it told last
    std::vector<std::uint32_t> heads_;  ///< of the slices, of the far, of those without a time
    std::vector<std::uint64_t> is_filled_;  ///< a bit for each of the lists
    LargeVector<Link> links_;               ///< by ball
    std::vector<Entry> heap_;               ///< each above four
    std::vector<std::uint32_t> moved_;
};

}  // namespace carom
