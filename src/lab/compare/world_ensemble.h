#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "game/commands/command.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// An ensemble: many copies of a world with slightly different starts, advanced together. In a
/// chaotic scene every ball becomes a cloud.
namespace carom {

struct EnsembleSettings {
    std::size_t copies = 200;  ///< >= 1
    double size = 1e-6;        ///< largest offset of a ball at the start, along each axis, a length
    std::uint64_t seed = 0;
};

class WorldEnsemble {
  public:
    /// Copy 0 is `start` itself; the others are perturbed (measure/nudge.h).
    WorldEnsemble(const World& start, const SolverSettings& solver,
                  const EnsembleSettings& settings);

    /// Advances every copy by a tick. `may_go_on` is asked between copies, `keep_going` within long
    /// ticks. Returns false when one of them says no; the next call continues from there.
    bool step(const std::function<bool()>& may_go_on = {},
              const std::function<bool()>& keep_going = {});
    /// Executes a command in every copy that does not refuse it. Pre: the last step() returned
    /// true.
    void execute(const Command& command);

    /// The worlds. After a step() that returned false, some are a tick ahead.
    std::span<const World> copies() const { return copies_; }
    double time() const { return copies_.front().time(); }
    /// For each ball, the root mean square distance of its copies from its first copy, in its
    /// radii; returns the largest. 0 with one copy, or without balls.
    double spread() const;

  private:
    Solver solver_;
    std::vector<World> copies_;
    std::size_t next_ = 0;  ///< the copy to advance next
};

/// The number of balls of all copies in each cell of a grid.
struct Density {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::uint32_t> counts;  ///< row by row, the first at the top

    std::uint32_t at(std::size_t column, std::size_t row) const {
        return counts[row * columns + column];
    }
};
/// The density over `view`, high sides excluded. A ball counts in the cell of its centre, and not
/// at all outside the view. `only`: counts only the copies of that ball. Pre: the view has an area;
/// columns and rows are at least 1.
Density density(std::span<const World> copies, const Box& view, std::size_t columns,
                std::size_t rows, std::optional<BallId> only = {});

}  // namespace carom
