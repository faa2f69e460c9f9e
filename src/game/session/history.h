#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/session/game_state.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// Snapshots of a world, in bounded memory, for rewinding.
namespace carom {

/// Together with the commands that follow, everything that the next tick depends on:
/// physics/world/README.md.
struct Snapshot {
    World world;
    SolverSettings solver;
    GameState game{};
};

/// The size of a snapshot of the world, without the game, in bytes.
std::size_t bytes_of_snapshot(const World& world);

/// Invariants: ascending by tick, no tick twice; bytes() <= the limit.
class History {
  public:
    /// Ticks between snapshots where they are densest, unless more are offered.
    static constexpr std::uint64_t spacing = 8;

    explicit History(std::size_t limit_bytes) : limit_(limit_bytes) {}

    /// Adds a snapshot, unless there is one of this tick, or it alone exceeds the limit. At the
    /// limit, snapshots are thinned: the spacing of those that are kept is proportional to their
    /// distance from this one.
    void keep(const World& world, const SolverSettings& solver, const GameState& game = {});

    /// The last snapshot at or before `tick`; null if there is none.
    const Snapshot* at_or_before(std::uint64_t tick) const;
    bool has(std::uint64_t tick) const;

    /// Drops the snapshots at `tick` and after it (forget_from), or before it (forget_before).
    void forget_from(std::uint64_t tick);
    void forget_before(std::uint64_t tick);
    void clear();
    /// Thins around `present` if the new limit requires it.
    void set_limit(std::size_t limit_bytes, std::uint64_t present);

    std::size_t bytes() const { return bytes_; }
    std::size_t size() const { return snapshots_.size(); }

  private:
    struct Kept {
        Snapshot snapshot;
        std::size_t bytes = 0;
    };
    void thin(std::uint64_t present);

    std::vector<Kept> snapshots_;
    std::size_t bytes_ = 0;
    std::size_t limit_ = 0;
};

}  // namespace carom
