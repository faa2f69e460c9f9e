#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "game/commands/command.h"
#include "game/pool/shot_setup.h"
#include "game/session/fingerprint_mark.h"
#include "level/scene/scene.h"
#include "physics/solver.h"

/// A recording: everything from which the deterministic core reproduces a game bit by bit.
///
/// The level's text is in it, with all included files, so that a recording needs no other file: it
/// can be watched and verified on another machine, and after the level has changed. A level is a
/// few kilobytes; the commands of a minute of dragging are more.
///
/// The text, one statement a line, numbers so that they read back to the same bits:
///
///     carom replay 3
///     program 0.1.0                       the carom that recorded it
///     physics 1                           the version of its physics (physics/version.h)
///     fingerprint 2                       which fingerprint the marks are (fingerprint.h)
///     level galton.level                  what it was called: the rest of the line
///     file 0                              its text, each line behind a bar; what follows the last
///     |carom 1 "Galton board"             line end of a file stands behind the last bar, so that
///     |include "parts/pegs.level"         a text that ends with a line end closes with an empty
///     |                                   bar
///     file 1
///     |peg 0,0
///     |
///     include 0 1 parts/pegs.level        in file 0, this path means file 1
///     hash 0123456789abcdef               of these texts and the statements of `set`
///     set use gravity 0,-1.6              overrides, any number of them
///     solver substep updates=4 steps=15 substeps=1
///     rate 120
///     seed 7
///     at 0 strike 3 1.5,-2                tick, command, its numbers
///     mark 0 0123456789abcdef             the fingerprint after that tick and its commands
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
///     at 67 press left                    and: release left
///     at 67 pull 0.25                     the plunger, by a quarter; and: launch 0.25
///     at 68 call pot 3 2                  ball 3 into pocket 2; or none, safety, push-out
///     at 69 decide break-again            or take-table, let-break, spot-eight, return-push
///     at 70 rack                          the next frame
///     mark 120 0123456789abcdef
///     opponent 3                          carom played the second player, with that skill;
///                                         absent: a person did
///     stance 30.5 2 0.1 -0.3 full pocket 4  the shot that was set up: bearing, speed, side and
///                                         follow of the tip, aids, intent, pocket
///     stands 1100                         where the player stood; absent: at the end
///     end 1200                            the last tick
///
/// A text that begins with `carom replay 2` has neither `physics` nor `fingerprint`: both are 1.
///
/// The lines `at` and `mark` are each in ascending order of ticks. Nothing may be missing but
/// `include`, `set`, `at`, `mark`, `opponent`, `stance` and `stands`. `end` is the last line:
/// without it the recording is not whole.
namespace carom {

struct Replay {
    int physics_version = 1;         ///< under which it was recorded
    int fingerprint_version = 1;     ///< that of the marks
    std::string program;             ///< version of the carom that recorded it; no line ends in it
    std::string level;               ///< no line ends in it
    std::vector<std::string> texts;  ///< the level's, then those of what it includes
    std::vector<Include> includes;   ///< indices into `texts`
    std::uint64_t level_hash = 0;
    int hash_line = 1;                   ///< where a text that was read says the hash, for messages
    std::vector<std::string> overrides;  ///< no line ends in them
    SolverSettings solver;               ///< at the start
    double rate = 120.0;                 ///< ticks a second
    std::uint64_t seed = 0;
    std::vector<TimedCommand> commands;
    std::vector<FingerprintMark> marks;
    std::uint64_t end = 0;     ///< the last tick
    std::uint64_t stands = 0;  ///< where the player stood, 0..end
    int opponent = 0;          ///< how well carom played at pool, 1..4; 0: two people
    std::optional<ShotSetup> stance;
};

std::string replay_text(const Replay& replay);

/// What is wrong with a text, where, and what to do.
struct ReplayError {
    int line = 1;
    std::string message;
    std::string remedy;
};
std::variant<Replay, ReplayError> read_replay(std::string_view text);

}  // namespace carom
