#pragma once

#include <optional>

#include "game/ai/pool_shots.h"
#include "game/pool/pool.h"

/// What a position is worth to a player, by a look at the table: nothing is simulated.
namespace carom {

/// How likely a pot falls, 0..1, for a hand whose bearing errs by this many degrees.
double pot_chance(const PotLine& line, double bearing_error);

struct Outlook {
    /// For the player whose turn it is: -1 the frame is lost, 1 it is won.
    double value = 0.0;
    /// The ball that is easiest to pocket, by its number; none: no pot is free, or the ball is in
    /// hand.
    std::optional<int> easiest;
    double chance = 0.0;  ///< that it falls
};

/// Pre: the balls lie still.
Outlook outlook(const Scene& scene, const World& world, const PoolPlay& play, const Box& cloth,
                double bearing_error);

/// The same for `player`, whoever's turn it is.
double value_to(int player, const Scene& scene, const World& world, const PoolPlay& play,
                const Box& cloth, double bearing_error);

/// The balls that the player whose turn it is may meet first.
std::vector<BallId> legal_balls(const PoolPlay& play);

}  // namespace carom
