#include "physics/contact/constraint_order.h"

#include <algorithm>

namespace carom {

void ConstraintOrder::arrange(std::span<const NearPair> pairs, std::span<const Vec2> place,
                              Vec2 gravity) {
    turn_.clear();
    if (gravity == Vec2{} || pairs.size() < 2) return;
    const Vec2 up = -gravity / length(gravity);
    if (sort_by_height(pairs, place, up)) regroup(pairs, static_cast<std::uint32_t>(place.size()));
}

// A counting sort. False: all pairs are at one height.
bool ConstraintOrder::sort_by_height(std::span<const NearPair> pairs, std::span<const Vec2> place,
                                     Vec2 up) {
    height_.resize(place.size());
    for (std::size_t i = 0; i < place.size(); ++i)
        height_[i] = dot(up, place[i]);
    const auto height_of = [&](const NearPair& pair) {
        const double a = height_[pair.a];
        return pair.b < place.size() ? a + height_[pair.b] : 2.0 * a;
    };
    double low = height_of(pairs[0]);
    double high = low;
    for (const NearPair& pair : pairs) {
        const double height = height_of(pair);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (!(high > low)) return false;
    constexpr std::size_t steps = 4096;
    const double scale = static_cast<double>(steps - 1) / (high - low);
    begin_.assign(steps + 1, 0);
    group_.resize(pairs.size());
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        const double step = (height_of(pairs[p]) - low) * scale;
        group_[p] = static_cast<std::uint32_t>(step > 0.0 ? std::min(step, steps - 1.0) : 0.0);
        ++begin_[group_[p] + 1];
    }
    for (std::size_t s = 1; s <= steps; ++s)
        begin_[s] += begin_[s - 1];
    upwards_.resize(pairs.size());
    for (std::uint32_t p = 0; p < pairs.size(); ++p)
        upwards_[begin_[group_[p]]++] = p;
    return true;
}

// A pair's level is one above the highest of the levels before it that its balls are in.
void ConstraintOrder::regroup(std::span<const NearPair> pairs, std::uint32_t balls) {
    last_level_.assign(balls + 1, 0);
    begin_.assign(2, 0);
    for (const std::uint32_t p : upwards_) {
        const NearPair& pair = pairs[p];
        std::uint32_t& a = last_level_[pair.a];
        std::uint32_t& b = last_level_[pair.b < balls ? pair.b : pair.a];
        a = b = std::max(a, b) + 1;
        group_[p] = a;
        if (a + 1 >= begin_.size()) begin_.resize(a + 2, 0);
        ++begin_[a + 1];
    }
    for (std::size_t s = 1; s < begin_.size(); ++s)
        begin_[s] += begin_[s - 1];
    turn_.resize(pairs.size());
    for (const std::uint32_t p : upwards_)
        turn_[begin_[group_[p]]++] = p;
}

}  // namespace carom
