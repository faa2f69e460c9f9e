#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace carom {

/// The fingerprint of the world and of the state of the game (game_state.h), after a tick and after
/// all commands of that tick.
struct FingerprintMark {
    std::uint64_t tick = 0;
    std::uint64_t fingerprint = 0;

    friend bool operator==(const FingerprintMark&, const FingerprintMark&) = default;
};

/// The ticks between the marks of a recording: one simulated second, but at least one tick.
constexpr std::uint64_t mark_interval(double rate) {
    return rate < 1.5 ? 1 : static_cast<std::uint64_t>(rate + 0.5);
}

/// The first tick at which both have a mark and the marks differ. Pre: both ascend by tick.
inline std::optional<std::uint64_t> first_difference(std::span<const FingerprintMark> one,
                                                     std::span<const FingerprintMark> other) {
    for (std::size_t i = 0, j = 0; i < one.size() && j < other.size();) {
        if (one[i].tick == other[j].tick && one[i++] != other[j++]) return one[i - 1].tick;
        if (i < one.size() && j < other.size()) {
            if (one[i].tick < other[j].tick)
                ++i;
            else if (other[j].tick < one[i].tick)
                ++j;
        }
    }
    return std::nullopt;
}

}  // namespace carom
