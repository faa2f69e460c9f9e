#pragma once

#include <optional>

#include "game/ai/pool_shots.h"
#include "game/pool/pool.h"

/// Static evaluation of a position at pool: nothing is simulated.
namespace carom {

/// The probability of a pot, 0..1, when the error of the bearing has this standard deviation,
/// degrees.
double pot_chance(const PotLine& line, double bearing_error);

struct Outlook {
    /// For the player whose turn it is: -1 means lost, 1 won.
    double value = 0.0;
    /// The number of the ball that is easiest to pocket; none: no pot is free, or the cue ball is
    /// in hand.
    std::optional<int> easiest;
    double chance = 0.0;  ///< of pocketing it
};

/// Pre: the balls are at rest.
Outlook outlook(const Scene& scene, const World& world, const PoolPlay& play, const Box& cloth,
                double bearing_error);

/// The value of the position for `player`, whoever's turn it is.
double value_to(int player, const Scene& scene, const World& world, const PoolPlay& play,
                const Box& cloth, double bearing_error);

/// The balls that the player whose turn it is may hit first.
std::vector<BallId> legal_balls(const PoolPlay& play);

/// pot_lines() to these balls, into the pockets that serve the player whose turn it is.
std::vector<PotLine> useful_lines(const Scene& scene, const World& world, const PoolPlay& play,
                                  const Box& cloth, Vec2 from, std::span<const BallId> balls);

}  // namespace carom
