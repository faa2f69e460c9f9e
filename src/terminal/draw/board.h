#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/scene/scene.h"

/// The board of a level: what lies within its outer edges, for tables of any shape. It depends on
/// the scene's start alone, so it is computed once.
namespace carom {

/// What is at a place, from the outside in.
enum class Ground : std::uint8_t {
    none,     ///< outside of the level, and everywhere in levels without a board
    rail,     ///< the frame around the board
    cushion,  ///< of a pool table: between the rail and the bed
    plastic,  ///< of a pinball table: closed off from the balls
    board
};
inline constexpr std::size_t ground_count = 5;

class Board {
  public:
    /// Pool tables, pinball tables, and levels whose theme names a board have one.
    ///
    /// A grid of cells is flooded from outside; edges, pockets and drains hold the flood back, and
    /// what stays dry is the board. If it reaches a ball, gaps of up to a few radii are closed. If
    /// it reaches a ball even so, there is no board. On a pinball table the balls' part of the
    /// board is flooded too; the rest are plastics. Cost: some 10^5 cells, and each edge once.
    explicit Board(const Scene& scene);

    Ground at(Vec2 place) const;
    bool is_empty() const { return cells_.empty(); }
    /// The box around board and rail. Pre: not empty.
    const Box& frame() const { return frame_; }

  private:
    void flood(const Scene& scene);

    Box box_;
    Box frame_;
    double cell_ = 1.0;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<Ground> cells_;
};

/// What a camera should show: the level's view, and all of its board.
Box shown_box(const Scene& scene, const Board& board);

/// Whether the level is a pool table.
bool is_pool_table(const Scene& scene);

}  // namespace carom
