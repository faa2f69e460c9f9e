#pragma once

#include <cstdint>

/// The shot that a player has set up between two shots. It belongs neither to the rules nor to the
/// world, but a resumed game restores it.
namespace carom {

/// How much of the coming shot is drawn.
enum class Aids : std::uint8_t {
    none,   ///< only the cue
    ghost,  ///< straight lines: the ghost ball, and the directions after the hit
    full,   ///< and a forecast until all balls are at rest
    cloud   ///< and the final positions of 20 forecasts with execution noise
};

struct ShotSetup {
    /// The call for the next shot: the ball and pocket that the aim gives, a chosen pocket, ...
    enum class Intent : std::uint8_t { automatic, pocket, safety, push_out };

    double bearing = 0.0;  ///< degrees, counter-clockwise from the right
    double speed = 2.0;    ///< length/s
    double side = 0.0;     ///< tip offset to the right, a share of the radius
    double follow = 0.0;   ///< tip offset upwards, a share of the radius
    Aids aids = Aids::ghost;
    Intent intent = Intent::automatic;
    int pocket = 0;  ///< the chosen pocket

    friend bool operator==(const ShotSetup&, const ShotSetup&) = default;
};

}  // namespace carom
