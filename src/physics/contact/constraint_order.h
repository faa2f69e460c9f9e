#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/near_pairs.h"

namespace carom {

/// In which order the solver `contact` iterates over its pairs: from the bottom up.
///
/// Pairs are sorted against gravity by the height of their contact, in 4096 steps; pairs of equal
/// height stay in the order in which they are given (PairRows). The result is then regrouped into
/// levels: no two pairs of a level share a ball, and each pair keeps its place relative to every
/// pair with which it shares one. So the iteration gives the same bits as the sorted order, while
/// the processor can overlap neighbouring pairs. Without gravity pairs stay as they are.
///
/// Cost: linear in pairs and balls. Memory is kept from call to call.
class ConstraintOrder {
  public:
    /// The pairs are of bodies (PairRows). `place`: the reference positions of the balls, by body;
    /// pairs with b >= place.size() are pairs of a ball and an edge.
    void arrange(std::span<const NearPair> pairs, std::span<const Vec2> place, Vec2 gravity);

    /// Index of the pair that comes `turn`-th.
    std::uint32_t operator[](std::uint32_t turn) const {
        return turn_.empty() ? turn : turn_[turn];
    }

  private:
    bool sort_by_height(std::span<const NearPair> pairs, std::span<const Vec2> place, Vec2 up);
    void regroup(std::span<const NearPair> pairs, std::uint32_t balls);

    std::vector<std::uint32_t> turn_;  // empty: as they are
    std::vector<double> height_;       // by ball
    std::vector<std::uint32_t> begin_;
    std::vector<std::uint32_t> group_;       // by pair: its step of height, then its level
    std::vector<std::uint32_t> last_level_;  // by ball
    std::vector<std::uint32_t> upwards_;     // pairs by height
};

}  // namespace carom
