#include "level/ir/ball_list.h"

#include <algorithm>
#include <limits>

namespace carom {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Whether the two differ at most in what a record has of its own.
bool can_share(const BallIr& a, const BallIr& b) {
    BallSpec spec = a;
    spec.position = b.position;
    return spec == b && a.racked == b.racked && a.gap == b.gap && a.binding == b.binding &&
           a.device == b.device;
}

}  // namespace

BallIr BallList::operator[](std::size_t i) const {
    const Record& record = records_[i];
    BallIr ball = shared_[record.shared];
    ball.position = record.position;
    ball.origin = record.origin;
    return ball;
}

bool BallList::push_back(const BallIr& ball) {
    const auto binding = static_cast<std::size_t>(ball.binding);
    if (binding >= last_shared_.size()) last_shared_.resize(binding + 1, none);
    std::uint32_t& last = last_shared_[binding];
    const bool is_new = last == none || !can_share(shared_[last], ball);
    if (is_new) {
        last = static_cast<std::uint32_t>(shared_.size());
        shared_.push_back(ball);
    }
    records_.push_back({ball.position, ball.origin, last});
    return is_new;
}

void BallList::remove(const std::vector<bool>& is_removed) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < records_.size(); ++i)
        if (!is_removed[i]) records_[kept++] = records_[i];
    records_.resize(kept);
}

}  // namespace carom
