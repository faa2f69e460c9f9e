#pragma once

#include <cstdint>

/// How a person stands at a pool table between two shots: none of it is in the rules or the world,
/// and all of it is wanted back when a game is gone on with.
namespace carom {

/// How much the table shows of what a shot will do.
enum class Aids : std::uint8_t {
    none,   ///< the cue alone
    ghost,  ///< straight lines: where the balls meet, and which ways they part
    full,   ///< and the engine run ahead until all lies still
    cloud   ///< and 20 shots of a hand that is not quite steady
};

struct PoolStance {
    /// What the next shot is said to be: what the aim pockets, a pocket that was chosen, ...
    enum class Intent : std::uint8_t { automatic, pocket, safety, push_out };

    double bearing = 0.0;  ///< degrees, counter-clockwise from the right
    double speed = 2.0;    ///< length/s
    double side = 0.0;     ///< of the tip, in shares of the radius, and so is `follow`
    double follow = 0.0;
    Aids aids = Aids::full;
    Intent intent = Intent::automatic;
    int pocket = 0;  ///< the chosen one

    friend bool operator==(const PoolStance&, const PoolStance&) = default;
};

}  // namespace carom
