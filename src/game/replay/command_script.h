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

/// The commands of a script, in ascending order of ticks, with the line (from 1) of each.
struct CommandScript {
    std::vector<TimedCommand> commands;
    std::vector<int> lines;
};

/// Reads the lines `at TICK COMMAND` of a recording (replay_text.h), for example
///
///     # the right wall goes to the left
///     at 0    hold-edge 2  39.9,0 39.9,20
///     at 120  drop-edge 2
///
/// Blanks may be repeated, lines may end with CR LF, and a comment goes from # to the end of its
/// line. An empty script is no error.
std::variant<CommandScript, ReplayError> read_script(std::string_view text);

/// An example of each command, for messages: "strike 0 1.5,-2".
std::span<const std::string_view> command_examples();

/// Executes commands at their ticks, in a world that the caller advances.
class ScriptRunner {
  public:
    /// Pre: in ascending order of ticks.
    explicit ScriptRunner(std::vector<TimedCommand> commands) : commands_(std::move(commands)) {}

    /// Why a command cannot be executed.
    struct Refused {
        std::size_t index = 0;  ///< of the command
        std::string reason;
    };
    /// Executes the commands of the world's present tick. Pre: called before the first tick and
    /// after every tick. The first refused command ends it; those before it have been executed.
    std::optional<Refused> execute_due(const Scene& scene, World& world, GameState& game,
                                       Solver& solver);

    /// The number of commands that have not been executed yet.
    std::size_t remaining() const { return commands_.size() - next_; }

  private:
    std::vector<TimedCommand> commands_;
    std::size_t next_ = 0;
};

}  // namespace carom
