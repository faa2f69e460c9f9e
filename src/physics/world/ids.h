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

/// Whether ids that ascend are consecutive: then each is the first and its index.
template <typename Id>
bool are_consecutive(const std::vector<Id>& ids) {
    return ids.empty() || number(ids.back()) - number(ids.front()) == ids.size() - 1;
}

}  // namespace carom
