#pragma once

#include <cstdint>

#include "game/commands/command.h"

namespace carom {

/// Execution noise: the standard deviations of a shot from its plan. The defaults are those of
/// FastFiz, the simulator of the computer olympiads.
struct ShotNoise {
    double bearing = 0.125;  ///< degrees
    double speed = 0.075;    ///< length/s
    double tip = 0.0175;     ///< in radii, to the side and up: 0.5 mm

    friend bool operator==(const ShotNoise&, const ShotNoise&) = default;
};

ShotNoise operator*(const ShotNoise& error, double factor);

/// The strike with noise: draw number `index` of this seed. The result is at most `most` fast and
/// its tip offset is possible; side and follow stay 0 where they are 0.
command::Strike with_noise(const command::Strike& strike, const ShotNoise& error, double most,
                           std::uint64_t seed, std::uint64_t index);

}  // namespace carom
