#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "game/replay/replay_text.h"
#include "game/session/game_state.h"

/// Commands without a recording around them, so that experiments can be scripted.
namespace carom {

/// A command of a script.
struct ScriptCommand : TimedCommand {
    bool waits_for_rest = false;  ///< `at rest`: its tick is the first in which all balls lie still
    bool is_of_cue = false;       ///< `strike cue`: of the ball that the player strikes
};

/// The commands of a script in their order, those with a tick ascending, with the line (from 1) of
/// each.
struct CommandScript {
    std::vector<ScriptCommand> commands;
    std::vector<int> lines;
};

/// Reads the lines `at TICK COMMAND` of a recording (replay_text.h), for example
///
///     # the right wall goes to the left
///     at 0    hold-edge 2  39.9,0 39.9,20
///     at 120  drop-edge 2
///
/// `at rest COMMAND` waits until all balls lie still and the shot is over, after the command above
/// it. `strike cue VX,VY` strikes the cue ball of the player whose turn it is:
///
///     at rest strike cue 2.5,0
///
/// Blanks may be repeated, lines may end with CR LF, and a comment goes from # to the end of its
/// line. An empty script is no error.
std::variant<CommandScript, ReplayError> read_script(std::string_view text);

/// Commands with their ticks, as a script.
std::vector<ScriptCommand> as_script(std::span<const TimedCommand> commands);

/// An example of each command, for messages: "strike 0 1.5,-2".
std::span<const std::string_view> command_examples();

/// Executes commands at their ticks, in a world that the caller advances.
class ScriptRunner {
  public:
    /// Pre: in the order of a CommandScript.
    explicit ScriptRunner(std::vector<ScriptCommand> commands) : commands_(std::move(commands)) {}

    /// Why a command cannot be executed.
    struct Refused {
        std::size_t index = 0;  ///< of the command
        std::uint64_t tick = 0;
        std::string reason;
    };
    /// Executes the commands of the world's present tick. Pre: called before the first tick and
    /// after every tick. The first refused command ends it; those before it have been executed.
    std::optional<Refused> execute_due(const Scene& scene, World& world, GameState& game,
                                       Solver& solver);

    /// The number of commands that have not been executed yet.
    std::size_t remaining() const { return commands_.size() - next_; }

    /// Those that have been executed, with the ticks and the balls that they found.
    std::vector<TimedCommand> executed() const;

  private:
    std::vector<ScriptCommand> commands_;
    std::size_t next_ = 0;
};

}  // namespace carom
