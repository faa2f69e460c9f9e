#include "physics/broad_phase/pairs.h"

#include <algorithm>

#include "geometry/closest.h"
#include "physics/memory/prefetch.h"
#include "physics/memory/zeros.h"

namespace carom {

bool overlaps_edge(const World& world, const EdgePair& pair, const Disc& disc) {
    Capsule shape = world.capsules().shape[pair.capsule];
    if (world.model().wrap) {
        const Vec2 torus = size(*world.model().wrap);
        const Vec2 shift{pair.across * torus.x, pair.along * torus.y};
        shape.start += shift;
        shape.end += shift;
    }
    const Vec2 offset = disc.center - closest_point(shape.start, shape.end, disc.center);
    const double reach = disc.radius + shape.radius;
    return length_squared(offset) < reach * reach;
}

// Few pairs are sorted as they are. Many are first sorted by counting, into about as many ranges of
// first balls as there are pairs; insertion then orders the few of each range.
void PairOrder::sort(std::vector<BallPair>& pairs, std::size_t balls) {
    if (pairs.size() < 64) {
        std::ranges::sort(pairs);
        return;
    }
    int shift = 0;
    while (balls >> shift > 2 * pairs.size())
        ++shift;
    assign_zeros(start_, (balls >> shift) + 1);
    for (const BallPair& pair : pairs)
        ++start_[pair.first >> shift];
    std::uint32_t end = 0;
    for (std::uint32_t& start : start_)
        start = end += start;
    sorted_.resize(pairs.size());
    for (const BallPair& pair : pairs)
        sorted_[--start_[pair.first >> shift]] = pair;
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
        const BallPair pair = sorted_[i];
        std::size_t at = i;
        for (; at > 0 && pair < sorted_[at - 1]; --at)
            sorted_[at] = sorted_[at - 1];
        sorted_[at] = pair;
    }
    pairs.swap(sorted_);
}

void BallAdjacency::build(std::span<const BallPair> pairs, std::size_t balls) {
    assign_zeros(start_, balls + 2);
    for (const BallPair& pair : pairs) {
        ++start_[pair.first + 2];
        ++start_[pair.second + 2];
    }
    for (std::size_t i = 2; i < start_.size(); ++i)
        start_[i] += start_[i - 1];
    others_.resize(2 * pairs.size());
    constexpr std::size_t ahead = 16;
    const auto fetch = [&](std::uint32_t ball) { prefetch_line(&others_[start_[ball + 1]]); };
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (p + ahead < pairs.size()) {
            fetch(pairs[p + ahead].first);
            fetch(pairs[p + ahead].second);
        }
        const BallPair& pair = pairs[p];
        others_[start_[pair.first + 1]++] = pair.second;
        others_[start_[pair.second + 1]++] = pair.first;
    }
}

}  // namespace carom
