#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "physics/world/bodies.h"

namespace carom {

/// An invariant that does not hold.
struct Breach {
    enum class Kind : std::uint8_t { not_finite, energy, side, escape, overlap, time };
    Kind kind = Kind::not_finite;
    std::uint64_t tick = 0;         ///< the first after which it does not, from 1
    std::optional<BallId> ball;     ///< none: the scene as a whole
    std::optional<BallId> other;    ///< that it overlaps
    std::optional<CapsuleId> edge;  ///< that it overlaps, or has passed
    double amount = 0.0;            ///< energy gained, depth, or speed of a ball that did not move
};
/// "energy", "side" ...
std::string_view name(Breach::Kind kind);
/// One line for people, without its end.
std::string text(const Breach& breach, double rate);

}  // namespace carom
