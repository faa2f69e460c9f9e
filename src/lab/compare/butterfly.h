#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "game/commands/command.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// The butterfly: many copies of a world that differ by a hair, advanced together, until chaos has
/// made a cloud of every ball.
namespace carom {

struct ButterflySettings {
    std::size_t copies = 200;  ///< >= 1
    double size = 1e-6;        ///< most that a ball is moved each way at the start, length
    std::uint64_t seed = 0;
};

class Butterfly {
  public:
    /// Copy 0 is `start` itself; the others are nudged (lab/nudge.h).
    Butterfly(const World& start, const SolverSettings& solver, const ButterflySettings& settings);

    /// A tick of every copy. `may_go_on` is asked between copies, `keep_going` within long ticks.
    /// Where one of them says no, the next call goes on where this one has stopped: false is
    /// returned.
    bool step(const std::function<bool()>& may_go_on = {},
              const std::function<bool()>& keep_going = {});
    /// Every copy obeys, but those where it makes no sense any more. Pre: the last step() was true.
    void obey(const Command& command);

    /// The worlds, whose balls are where they are in each copy. Where step() was false, some are a
    /// tick ahead.
    std::span<const World> copies() const { return copies_; }
    double time() const { return copies_.front().time(); }
    /// How far the copies of one ball are from the first copy's, root mean square, in its radii; of
    /// the ball whose copies are furthest. 0 where there is only one copy, or there are no balls.
    double spread() const;

  private:
    Solver solver_;
    std::vector<World> copies_;
    std::size_t next_ = 0;  ///< copy to be advanced
};

/// How many balls of all copies are in each cell of a grid.
struct Density {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::uint32_t> counts;  ///< row by row, the first at the top

    std::uint32_t at(std::size_t column, std::size_t row) const {
        return counts[row * columns + column];
    }
};
/// Over `view`, high sides excluded; a ball counts where its centre is, and not at all outside.
/// `only`: of that ball alone. Pre: the view has an area; columns and rows at least 1.
Density density(std::span<const World> copies, const Box& view, std::size_t columns,
                std::size_t rows, std::optional<BallId> only = {});

}  // namespace carom
