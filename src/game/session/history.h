#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/session/game_state.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// Snapshots of a world, in bounded memory, for the way back.
namespace carom {

/// Everything that the next tick depends on, beside the commands that follow.
struct Snapshot {
    World world;
    SolverSettings solver;
    GameState game{};
};

/// What a snapshot of the world occupies, in bytes; without the game.
std::size_t bytes_of(const World& world);

/// Invariants: ascending by tick, no tick twice; bytes() <= the limit.
class History {
  public:
    /// Ticks between snapshots where they are densest, unless offered more often.
    static constexpr std::uint64_t spacing = 8;

    explicit History(std::size_t limit_bytes) : limit_(limit_bytes) {}

    /// Keeps a snapshot when it helps: not when the same tick is there, and not when one alone is
    /// over the limit. Where the limit is reached, snapshots are thinned: of all that are kept, two
    /// neighbours stand the farther apart the farther they are from this one, in proportion.
    void keep(const World& world, const SolverSettings& solver, const GameState& game = {});

    /// The last snapshot at or before `tick`; null when there is none.
    const Snapshot* at_or_before(std::uint64_t tick) const;
    bool has(std::uint64_t tick) const;

    /// Forgets the snapshots at `tick` and after it; before `tick`.
    void forget_from(std::uint64_t tick);
    void forget_before(std::uint64_t tick);
    void clear();
    /// Thins around `present` where the new limit asks for it.
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
