#pragma once

#include <cstdint>

#include "game/commands/command.h"

namespace carom {

/// How far a person's cue is off what was meant: standard deviations. The values that stand here
/// are those of FastFiz, by which the programs of the computer olympiads were judged.
struct HandError {
    double bearing = 0.125;  ///< degrees
    double speed = 0.075;    ///< length/s
    double tip = 0.0175;     ///< of the radius, to the side and up: 0.5 mm

    friend bool operator==(const HandError&, const HandError&) = default;
};

HandError operator*(const HandError& error, double factor);

/// The strike as it comes out, number `index` of those that the seed gives. No faster than `most`,
/// no further off the middle than a tip can be; side and follow stay 0 where they are.
command::Strike with_error(const command::Strike& strike, const HandError& error, double most,
                           std::uint64_t seed, std::uint64_t index);

}  // namespace carom
