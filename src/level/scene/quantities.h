#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "physics/world/ids.h"

/// The quantities that an `expect` can measure. A new quantity is a row in quantities.cpp and one
/// where it is computed: in lab/run/figures.cpp, or in lab/run/judge.cpp for balls and bins.
namespace carom {

enum class QuantityScope : std::uint8_t {
    world,  ///< computed from the present world, as in `expect energy`
    run,    ///< over all ticks so far, or relative to the start, as in `expect overlap`
    ball,   ///< of a named ball that still exists, as in `expect cue.x`
    bins,   ///< of a group of bins, as in `expect mean(bins)`; the leftmost bin counts as 0
};

struct QuantityRow {
    std::string_view name;  ///< as written in levels
    QuantityScope scope = QuantityScope::world;
};
/// A row of quantities(), never null in a loaded level.
using QuantityKind = const QuantityRow*;

struct Quantity {
    QuantityKind kind = nullptr;
    BallId ball{};  ///< of scope `ball`
    /// Of scope `bins`: indices into World::counters, from left to right ...
    std::vector<std::uint32_t> counters;
    /// ... and the expected share of each, for variance_ratio and chi_square: from the level's
    /// `show histogram` of the same bins, else the binomial distribution of fair tosses.
    std::vector<double> expected;
};

bool is_of_ball(QuantityKind kind);
bool is_of_bins(QuantityKind kind);
/// The name in levels: "collisions", "x", "mean".
std::string_view name(QuantityKind kind);
/// All quantities, in the order in which messages list them.
std::vector<QuantityKind> quantity_kinds();
/// The quantity of this name; null if there is none.
QuantityKind quantity_named(std::string_view name);

/// The probabilities of k hits in n tosses with probability p, for k = 0..n. Computed by recurrence
/// from the most likely k, so no relevant value over- or underflows; they add up to 1 within
/// rounding. Pre: n >= 0, 0 <= p <= 1.
std::vector<double> binomial_shares(int n, double p);

}  // namespace carom
