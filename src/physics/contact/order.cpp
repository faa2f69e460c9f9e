#include <algorithm>

#include "physics/contact/solver.h"

// The order in which the solver `contact` goes through its pairs.
namespace carom {

// Against gravity, by the height of the contact in 4096 steps; what is as high stays in the order
// of the cells. Then into shifts: in each no two pairs have a body in common, and each pair comes
// after all that were before it and share a body with it, so that the result is that of the first
// order, bit by bit, but the processor need not wait for one pair to begin the next.
void ContactSolver::order_pairs() {
    const std::vector<NearPair>& near = near_.pairs();
    turn_.clear();
    if (gravity_ == Vec2{} || near.size() < 2) return;
    const Vec2 up = -gravity_ / length(gravity_);
    height_.resize(still_);
    for (std::uint32_t i = 0; i < still_; ++i)
        height_[i] = dot(up, home_[i]);
    const auto height_of = [&](const NearPair& pair) {
        const double a = height_[pair.a];
        return pair.b < still_ ? a + height_[pair.b] : 2.0 * a;
    };
    double low = height_of(near[0]);
    double high = low;
    for (const NearPair& pair : near) {
        const double height = height_of(pair);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (!(high > low)) return;
    constexpr std::size_t steps = 4096;
    const double scale = static_cast<double>(steps - 1) / (high - low);
    begin_.assign(steps + 1, 0);
    shift_.resize(near.size());
    for (std::size_t p = 0; p < near.size(); ++p) {
        const double step = (height_of(near[p]) - low) * scale;
        shift_[p] = static_cast<std::uint32_t>(step > 0.0 ? std::min(step, steps - 1.0) : 0.0);
        ++begin_[shift_[p] + 1];
    }
    for (std::size_t s = 1; s <= steps; ++s)
        begin_[s] += begin_[s - 1];
    upwards_.resize(near.size());
    for (std::uint32_t p = 0; p < near.size(); ++p)
        upwards_[begin_[shift_[p]]++] = p;

    last_shift_.assign(still_ + 1, 0);
    begin_.assign(2, 0);
    for (const std::uint32_t p : upwards_) {
        const NearPair& pair = near[p];
        std::uint32_t& a = last_shift_[pair.a];
        std::uint32_t& b = last_shift_[pair.b < still_ ? pair.b : pair.a];
        a = b = std::max(a, b) + 1;
        shift_[p] = a;
        if (a + 1 >= begin_.size()) begin_.resize(a + 2, 0);
        ++begin_[a + 1];
    }
    for (std::size_t s = 1; s < begin_.size(); ++s)
        begin_[s] += begin_[s - 1];
    turn_.resize(near.size());
    for (const std::uint32_t p : upwards_)
        turn_[begin_[shift_[p]]++] = p;
}

}  // namespace carom
