#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "physics/world/ids.h"

/// What an `expect` can measure.
namespace carom {

enum class QuantityKind : std::uint8_t {
    collisions,        ///< ball on ball and ball on edge together
    ball_ball,         ///< collisions of ball and ball
    ball_edge,         ///< collisions of ball and edge
    kinetic_energy,    ///< of all balls
    potential_energy,  ///< of all balls, under gravity, 0 at the origin
    energy,            ///< both
    momentum_x,        ///< of all balls
    momentum_y,
    angular_momentum,  ///< of all balls, about the origin
    time,              ///< s since the start
    escaped,           ///< balls outside the closed outline that they started in
    overlap,           ///< the deepest at the end of any tick, a length
    balls,             ///< balls that are there
    removed,           ///< balls that are no longer there
    // Of a named ball. It must still be there.
    x,
    y,
    vx,
    vy,
    speed,
    w,  ///< spin, rad/s, counter-clockwise; 0 where balls do not turn
    // Of a group of bins, NAME in brackets, as in mean(bins). A ball counts as the number of its
    // bin, 0 for the leftmost.
    count,           ///< balls in all bins
    mean,            ///< of the bins' numbers
    variance,        ///< of the bins' numbers (divided by the count)
    variance_ratio,  ///< variance over that of the expected shares
    chi_square       ///< sum of (counted - expected)^2 / expected over the bins
};

struct Quantity {
    QuantityKind kind = QuantityKind::collisions;
    BallId ball{};  ///< for x, y, vx, vy, speed and w
    /// For count to chi_square: indices into World::counters, from left to right ...
    std::vector<std::uint32_t> counters;
    /// ... and the share of each, for variance_ratio and chi_square: what the level's `show
    /// histogram` of the same bins says, else the binomial of fair tosses.
    std::vector<double> expected;
};

bool is_of_ball(QuantityKind kind);
bool is_of_bins(QuantityKind kind);
/// As a level writes it: "collisions", "x", "mean".
std::string_view name(QuantityKind kind);
/// All of them, in order.
std::vector<QuantityKind> quantity_kinds();

/// Shares of n tosses with probability p: k hits for k = 0..n. By recurrence from the likeliest
/// one, so nothing over- or underflows that matters; they add up to 1 within rounding.
/// Pre: n >= 0, 0 <= p <= 1.
std::vector<double> binomial_shares(int n, double p);

}  // namespace carom
