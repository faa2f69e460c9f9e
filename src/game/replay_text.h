#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "game/command.h"
#include "physics/solver.h"

/// A game written down: everything that, by the determinism of the core, gives it again bit by bit.
///
/// The text, one statement a line, numbers so that they read back to the same bits:
///
///     carom replay 1
///     level levels/gas.level              the rest of the line, as it was asked for
///     hash 0123456789abcdef               of the level's text and all that it includes
///     solver substep updates=4 steps=15 substeps=1
///     rate 120
///     seed 7
///     set use gravity 0,-1.6              overrides, any number of them
///     at 0 strike 3 1.5,-2                tick, command, its numbers
///     at 12 hold-ball 3 10,20
///     at 40 drop-ball 3
///     at 50 hold-edge 2 0,0 10,5
///     at 60 drop-edge 2
///     at 60 place-ball 1 3,4
///     at 60 place-edge 2 0,0 10,6
///     at 61 add-ball 0 5,5 0,0 r=1 m=2 e=0.5
///     at 62 remove-ball 4
///     at 63 add-edge 0 0,0 10,0 0.5 both
///     at 64 remove-edge 5
///     at 65 gravity 0,-9.81               or: gravity off
///     at 66 solver swept updates=4 steps=15 substeps=1
///     mark 600 0123456789abcdef           the fingerprint after that tick
///     end 1200                            the last tick
///     stands 1100                         where the player stood; absent: at the end
///
/// The lines `at` and `mark` are each in ascending order of ticks. Nothing may be missing but
/// `set`, `at`, `mark` and `stands`; `end` or `stands` closes the text, so that a torn file is
/// noticed.
namespace carom {

/// What the world's fingerprint was.
struct FingerprintMark {
    std::uint64_t tick = 0;
    std::uint64_t fingerprint = 0;

    friend bool operator==(const FingerprintMark&, const FingerprintMark&) = default;
};

struct Replay {
    std::string level;  ///< no line ends in it
    std::uint64_t level_hash = 0;
    SolverSettings solver;  ///< at the start
    double rate = 120.0;    ///< ticks a second
    std::uint64_t seed = 0;
    std::vector<std::string> overrides;  ///< no line ends in them
    std::vector<TimedCommand> commands;
    std::vector<FingerprintMark> marks;
    std::uint64_t end = 0;     ///< the last tick
    std::uint64_t stands = 0;  ///< where the player stood, 0..end
};

std::string replay_text(const Replay& replay);

/// What is wrong with a text, and where.
struct ReplayError {
    int line = 1;
    std::string message;
};
std::variant<Replay, ReplayError> read_replay(std::string_view text);

}  // namespace carom
