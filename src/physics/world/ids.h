#pragma once

#include <cstdint>
#include <vector>

/// Names of things in the world. Given once, in ascending order, and never used again: order by id
/// is order of birth, and every tie in carom is broken by it.
namespace carom {

enum class BallId : std::uint32_t {};
enum class CapsuleId : std::uint32_t {};

constexpr std::uint32_t number(BallId id) {
    return static_cast<std::uint32_t>(id);
}
constexpr std::uint32_t number(CapsuleId id) {
    return static_cast<std::uint32_t>(id);
}

/// The ids that a world gives next. To give back those of balls from some id on, set `next_ball`
/// to it; no ball may have one of them.
struct NextIds {
    std::uint32_t next_ball = 0;
    std::uint32_t next_capsule = 0;

    BallId take_ball() { return BallId{next_ball++}; }
    CapsuleId take_capsule() { return CapsuleId{next_capsule++}; }
};

/// Whether ids that ascend are consecutive: then each is the first and its index.
template <typename Id>
bool are_consecutive(const std::vector<Id>& ids) {
    return ids.empty() || number(ids.back()) - number(ids.front()) == ids.size() - 1;
}

}  // namespace carom
