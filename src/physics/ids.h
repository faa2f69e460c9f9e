#pragma once

#include <cstdint>

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

}  // namespace carom
