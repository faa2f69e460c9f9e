#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/world.h"

/// Pairs of bodies that could meet, by index in the world: of two balls, and of a ball and an edge.
namespace carom {

/// Two balls, first < second.
struct BallPair {
    std::uint32_t first = 0;
    std::uint32_t second = 0;

    friend auto operator<=>(const BallPair&, const BallPair&) = default;
};

/// A ball and an edge; on a torus, the periodic image index of the edge: by how many heights and
/// widths of the torus it is shifted.
struct EdgePair {
    std::uint32_t ball = 0;
    std::uint32_t capsule = 0;
    std::int8_t along = 0;
    std::int8_t across = 0;

    friend auto operator<=>(const EdgePair&, const EdgePair&) = default;
};

/// Whether `disc` overlaps the edge of the pair, whatever its ball.
bool overlaps_edge(const World& world, const EdgePair& pair, const Disc& disc);

/// Puts pairs of balls in ascending order.
class PairOrder {
  public:
    /// `balls`: how many there are. Cost: linear in the pairs.
    void sort(std::vector<BallPair>& pairs, std::size_t balls);

  private:
    std::vector<std::uint32_t> start_;
    std::vector<BallPair> sorted_;
};

/// Pairs of balls, listed by ball.
class BallAdjacency {
  public:
    void clear() { start_.clear(); }
    bool is_empty() const { return start_.empty(); }
    /// `balls`: how many there are. Cost: linear in both.
    void build(std::span<const BallPair> pairs, std::size_t balls);
    /// The balls in pairs with `ball`, in no order. Pre: built.
    std::span<const std::uint32_t> of(std::uint32_t ball) const {
        return std::span(others_).subspan(start_[ball], start_[ball + 1] - start_[ball]);
    }

  private:
    std::vector<std::uint32_t> start_;
    std::vector<std::uint32_t> others_;
};

}  // namespace carom
