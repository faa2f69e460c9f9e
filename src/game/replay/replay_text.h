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

/// A recording: all inputs from which the deterministic core reproduces a game bit by bit.
///
/// It contains the level's text and all included files, so it needs no other file: it can be
/// watched and verified on another machine, and after the level has changed. A level is a few
/// kilobytes; the commands of a minute of dragging are more.
///
/// One statement a line; numbers are written so that they read back to the same bits:
///
///     carom replay 3
///     program 0.1.0                       the carom that recorded it
///     physics 1                           the version of its physics (physics/version.h)
///     fingerprint 2                       the version of the fingerprint in marks (fingerprint.h)
///     level galton.level                  its name: the rest of the line
///     file 0                              its text, each line after a bar; the text after the last
///     |carom 1 "Galton board"             line end follows the last bar, so a text that ends with
///     |include "parts/pegs.level"         a line end has an empty last bar
///     |
///     file 1
///     |peg 0,0
///     |
///     include 0 1 parts/pegs.level        in file 0, this path means file 1
///     hash 0123456789abcdef               the hash of these texts and the statements of `set`
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
///     at 69 decide break-again            or take-table, let-break, spot-eight, return-push,
///                                         replace
///     at 70 rack                          the next frame
///     at 71 time-out                      the shot clock has run out
///     at 72 concede                       the player whose turn it is concedes the frame
///     mark 120 0123456789abcdef
///     opponent 3                          the number of the AI player that is the second player
///                                         (ai/opponents.h); absent: a person
///     stance 30.5 2 0.1 -0.3 full pocket 4  the shot being set up: bearing, speed, side and
///                                         follow of the tip, aids, intent, pocket
///     time-left 12.5                      s on the shot clock; absent: all of it
///     unranked                            the game is not for the high scores: the player went
///                                         back and changed it, say, or carom played in it
///     stands 1100                         the player's position in time; absent: the end
///     end 1200                            the last tick
///
/// A text that begins with `carom replay 2` has neither `physics` nor `fingerprint`: both are 1.
///
/// The lines `at` and `mark` are each in ascending order of ticks. If there are marks, the last one
/// lies at most a second before `end`. All lines are required but
/// `include`, `set`, `at`, `mark`, `opponent`, `stance`, `time-left`, `unranked` and `stands`.
/// `end` is the last line: without it the recording is incomplete.
namespace carom {

struct Replay {
    int physics_version = 1;         ///< of the recorded game
    int fingerprint_version = 1;     ///< of the marks
    std::string program;             ///< version of the recording carom; no line ends in it
    std::string level;               ///< no line ends in it
    std::vector<std::string> texts;  ///< the level's, then those of its includes
    std::vector<Include> includes;   ///< indices into `texts`
    std::uint64_t level_hash = 0;
    int hash_line = 1;  ///< line of the hash in the text that was read, for messages
    std::vector<std::string> overrides;  ///< no line ends in them
    SolverSettings solver;               ///< at the start
    double rate = 120.0;                 ///< ticks a second
    std::uint64_t seed = 0;
    std::vector<TimedCommand> commands;
    std::vector<FingerprintMark> marks;
    std::uint64_t end = 0;       ///< the last tick
    std::uint64_t position = 0;  ///< the tick where the player stopped, 0..end
    int opponent = 0;            ///< pool: number of the AI player; 0: two people
    std::optional<ShotSetup> setup;
    std::optional<double> time_left;  ///< on the shot clock, s
    bool is_unranked = false;         ///< pinball: not for the high scores
};

std::string replay_text(const Replay& replay);

/// The error in a text, its position, and the remedy.
struct ReplayError {
    int line = 1;
    std::string message;
    std::string remedy;
};
std::variant<Replay, ReplayError> read_replay(std::string_view text);

}  // namespace carom
