#include "lab/measure/contact_order.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace carom {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

auto pair_of(const Meeting& meeting) {
    return std::tuple(meeting.kind, meeting.a, meeting.b);
}

bool is_same_pair(const Meeting& x, const Meeting& y) {
    return pair_of(x) == pair_of(y);
}

// The indices of the contacts, sorted by pair of bodies; within a pair they keep their order.
std::vector<std::size_t> by_pair(std::span<const Meeting> meetings) {
    std::vector<std::size_t> order(meetings.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return pair_of(meetings[i]); });
    return order;
}

// For each contact of the run, the index of its counterpart in the truth, or `none`.
std::vector<std::size_t> partners(std::span<const Meeting> truth, std::span<const Meeting> given) {
    std::vector<std::size_t> partner(given.size(), none);
    const std::vector<std::size_t> in_truth = by_pair(truth);
    const std::vector<std::size_t> in_given = by_pair(given);
    std::size_t t = 0;
    std::size_t g = 0;
    while (t < in_truth.size() && g < in_given.size()) {
        const auto of_truth = pair_of(truth[in_truth[t]]);
        const auto of_given = pair_of(given[in_given[g]]);
        if (of_truth == of_given) {
            partner[in_given[g++]] = in_truth[t++];
        } else if (of_truth < of_given) {
            ++t;
        } else {
            ++g;
        }
    }
    return partner;
}

// The indices of the contacts of every ball, ball by ball, in order.
struct OfBall {
    std::uint32_t ball = 0;
    std::size_t place = 0;
};
std::vector<OfBall> by_ball(std::span<const Meeting> meetings) {
    std::vector<OfBall> all;
    all.reserve(2 * meetings.size());
    for (std::size_t i = 0; i < meetings.size(); ++i) {
        all.push_back({meetings[i].a, i});
        if (meetings[i].kind == ContactKind::ball_ball) all.push_back({meetings[i].b, i});
    }
    std::ranges::stable_sort(all, {}, &OfBall::ball);
    return all;
}

// Annotations all of `places` except one longest increasing subsequence (patience sorting).
void mark_out_of_order(std::span<const std::size_t> places, const std::vector<std::size_t>& value,
                       std::vector<bool>& marked) {
    std::vector<std::size_t> tails;  // by length: the end of the best subsequence in `places`
    std::vector<std::size_t> before(places.size(), none);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto at = std::ranges::lower_bound(tails, value[places[i]], {},
                                                 [&](std::size_t t) { return value[places[t]]; });
        if (at != tails.begin()) before[i] = *(at - 1);
        if (at == tails.end()) {
            tails.push_back(i);
        } else {
            *at = i;
        }
    }
    std::vector<bool> kept(places.size(), false);
    for (std::size_t i = tails.empty() ? none : tails.back(); i != none; i = before[i])
        kept[i] = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!kept[i]) marked[places[i]] = true;
    }
}

// For each ball, the indices of its contacts, without consecutive repeats.
std::vector<std::vector<std::size_t>> distinct_by_ball(std::span<const Meeting> meetings,
                                                       std::uint32_t balls) {
    std::vector<std::vector<std::size_t>> found(balls);
    for (const OfBall& entry : by_ball(meetings)) {
        std::vector<std::size_t>& places = found[entry.ball];
        if (places.empty() || !is_same_pair(meetings[places.back()], meetings[entry.place]))
            places.push_back(entry.place);
    }
    return found;
}

std::uint32_t balls_in(std::span<const Meeting> meetings) {
    std::uint32_t count = 0;
    for (const Meeting& meeting : meetings) {
        count = std::max(count, meeting.a + 1);
        if (meeting.kind == ContactKind::ball_ball) count = std::max(count, meeting.b + 1);
    }
    return count;
}

std::optional<Meeting> meeting_at(std::span<const Meeting> meetings,
                                  const std::vector<std::size_t>& places, std::size_t index) {
    if (index >= places.size()) return std::nullopt;
    return meetings[places[index]];
}

}  // namespace

void note_meetings(std::vector<Meeting>& meetings, std::span<const Contact> contacts) {
    for (const Contact& contact : contacts)
        meetings.push_back({contact.time, contact.kind, contact.a, contact.b});
}

OrderFaults order_faults(std::span<const Meeting> truth, std::span<const Meeting> given) {
    const std::vector<std::size_t> partner = partners(truth, given);
    const auto alone = static_cast<std::size_t>(std::ranges::count(partner, none));
    const std::size_t paired = given.size() - alone;

    std::vector<bool> marked(given.size(), false);
    std::vector<std::size_t> places;
    const std::vector<OfBall> all = by_ball(given);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (partner[all[i].place] != none) places.push_back(all[i].place);
        if (i + 1 < all.size() && all[i + 1].ball == all[i].ball) continue;
        mark_out_of_order(places, partner, marked);
        places.clear();
    }
    return {.missed = truth.size() - paired,
            .extra = alone,
            .out_of_order = static_cast<std::size_t>(std::ranges::count(marked, true))};
}

std::optional<FirstDifference> first_difference(std::span<const Meeting> first,
                                                std::span<const Meeting> second, double until) {
    const std::uint32_t balls = std::max(balls_in(first), balls_in(second));
    const auto of_first = distinct_by_ball(first, balls);
    const auto of_second = distinct_by_ball(second, balls);
    std::optional<FirstDifference> earliest;
    for (std::uint32_t ball = 0; ball < balls; ++ball) {
        std::size_t i = 0;
        std::optional<Meeting> a = meeting_at(first, of_first[ball], 0);
        std::optional<Meeting> b = meeting_at(second, of_second[ball], 0);
        while (a && b && is_same_pair(*a, *b)) {
            ++i;
            a = meeting_at(first, of_first[ball], i);
            b = meeting_at(second, of_second[ball], i);
        }
        if (!a && !b) continue;
        const double time = a && b ? std::min(a->time, b->time) : a ? a->time : b->time;
        if (!(a && b) && time >= until) continue;
        if (!earliest || time < earliest->time) earliest = {ball, a, b, time};
    }
    return earliest;
}

}  // namespace carom
