#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "physics/world/ids.h"

/// What an `expect` can measure. A new quantity is a row in quantities.cpp, and one where it is
/// computed: in lab/run/figures.cpp, or in lab/run/judge.cpp where it is of a ball or of bins.
namespace carom {

enum class QuantityScope : std::uint8_t {
    world,  ///< read off the world, as in `expect energy`
    run,    ///< of all ticks so far, or of the start too, as in `expect overlap`
    ball,   ///< of a named ball that is still there, as in `expect cue.x`
    bins,   ///< of a group of bins, as in `expect mean(bins)`; the leftmost bin counts as 0
};

struct QuantityRow {
    std::string_view name;  ///< as levels write it
    QuantityScope scope = QuantityScope::world;
};
/// A row of quantities(), never null in a level that was loaded.
using QuantityKind = const QuantityRow*;

struct Quantity {
    QuantityKind kind = nullptr;
    BallId ball{};  ///< of scope `ball`
    /// Of scope `bins`: indices into World::counters, from left to right ...
    std::vector<std::uint32_t> counters;
    /// ... and the share of each, for variance_ratio and chi_square: what the level's `show
    /// histogram` of the same bins says, else the binomial of fair tosses.
    std::vector<double> expected;
};

bool is_of_ball(QuantityKind kind);
bool is_of_bins(QuantityKind kind);
/// As a level writes it: "collisions", "x", "mean".
std::string_view name(QuantityKind kind);
/// All of them, in the order in which messages list them.
std::vector<QuantityKind> quantity_kinds();
/// Null when there is no such quantity.
QuantityKind quantity_named(std::string_view name);

/// Shares of n tosses with probability p: k hits for k = 0..n. By recurrence from the likeliest
/// one, so nothing over- or underflows that matters; they add up to 1 within rounding.
/// Pre: n >= 0, 0 <= p <= 1.
std::vector<double> binomial_shares(int n, double p);

}  // namespace carom
