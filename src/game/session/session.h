#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "game/commands/command.h"
#include "game/session/fingerprint_mark.h"
#include "game/session/game_state.h"
#include "game/session/history.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// A game in progress: a scene, what the player has done to it, and the way back.
namespace carom {

/// Holds, at every moment: the world after the present tick and after all commands of that tick. To
/// go back is to take the nearest snapshot and to compute again, with the logged commands, what
/// came after it: the same bits, because the core is deterministic.
///
/// Memory for the way back is bounded (see `rewind_bytes`): snapshots are thinned, dense near the
/// present and ever sparser away from it, so that going back by n ticks costs about n ticks of
/// computing at most, wherever one stands. The start is the scene itself, so the way back ends at
/// tick 0 unless the log of commands alone outgrows half of the memory (about 100 bytes a command;
/// with 64 MiB, more than half an hour of uninterrupted dragging): then the older half of it is
/// forgotten, and earliest() says where the way back ends now.
class Session {
  public:
    static constexpr std::size_t default_rewind_bytes = std::size_t{64} << 20;

    /// `rewind_bytes`: most memory for the way back (snapshots and commands).
    /// Pre: solver.kind is one of solvers_available().
    Session(Scene scene, const SolverSettings& solver,
            std::size_t rewind_bytes = default_rewind_bytes);

    const Scene& scene() const { return scene_; }
    const World& world() const { return world_; }
    /// What the game's rules remember.
    const GameState& game() const { return game_; }
    const SolverSettings& solver() const { return solver_.settings(); }
    /// Contacts of the last tick; empty at the start and after a restart.
    std::span<const Contact> contacts() const { return contacts_; }

    /// The cells in which the solver looked for neighbours in the tick that it computed last.
    /// Before the first one, a single cell of side 1: CellFrame{}.
    const CellFrame& cells() const { return solver_.cells(); }

    /// Applies at once, before the next tick; logged with the present tick. Commands about what
    /// does not exist, and balls or edges that would overlap others, are refused with a sentence
    /// that says why. When the present is behind latest(), the future is forgotten first, and what
    /// it still held is dropped: that hand is in a future that no longer is.
    std::optional<std::string> apply(const Command& command);

    /// One tick forward. Behind latest(), this replays the commands that follow. False, and nothing
    /// happens, only at the end of what is followed, and where the tick was given up.
    bool step_forward();
    /// One tick back, to exactly the state that was. False at the start, or where the memory ends.
    bool step_back();
    /// Goes to a tick in earliest()..latest() by the shortest way; false when it is outside, and
    /// where a tick on the way was given up: the present is then before it.
    bool go_to(std::uint64_t tick);
    /// Forward to the first tick in which two bodies meet that did not meet in the tick before;
    /// at most `limit` ticks. False when there was none in them.
    bool step_to_collision(std::uint64_t limit);
    /// Goes back to just before the last gesture at or before the present (all of a drag counts as
    /// one) and forgets it with all that followed. False when there is nothing left to undo.
    bool undo();

    /// Asked now and then within a long tick, wherever one is computed; false gives it up.
    void set_keep_going(std::function<bool()> keep_going) { keep_going_ = std::move(keep_going); }
    /// How the last tick that was begun ended.
    TickOutcome outcome() const { return outcome_; }

    /// The earliest tick that can be gone back to, and the latest that has been reached.
    std::uint64_t earliest() const { return base_ ? base_->world.tick : 0; }
    std::uint64_t latest() const { return latest_; }
    /// Back to the start, commands forgotten; the solver stays.
    void restart();

    /// In the order in which they were applied, those of the replayable future included.
    std::span<const TimedCommand> commands() const { return log_; }
    /// Whether commands() go back to the start, so that the session can be written down.
    bool is_complete() const { return !base_; }
    /// One for each interval that has been reached, in ascending order of ticks.
    std::span<const FingerprintMark> marks() const { return marks_; }
    /// The log of commands may outgrow its share of the memory, so that it stays complete.
    void keep_all_commands() { keeps_all_commands_ = true; }

    /// What will be done is known up to the tick `end`: step_forward() does it, and goes no
    /// further; commands are refused. Pre: nothing has happened yet; the commands are in ascending
    /// order of ticks, none after `end`.
    void follow(std::vector<TimedCommand> commands, std::uint64_t end);
    bool is_following() const { return is_following_; }
    /// There is nothing left to follow.
    bool is_at_end() const { return is_following_ && world_.tick >= latest_; }
    void stop_following() { is_following_ = false; }
    /// Why a command that was followed could not be obeyed: a sentence that begins with its tick.
    /// What is followed then ends there.
    const std::optional<std::string>& fault() const { return fault_; }

    /// The solver at the start: SetSolver commands tell the rest.
    const SolverSettings& first_solver() const { return first_solver_; }

    /// What the way back holds now, in bytes: snapshots and commands. Never over `rewind_bytes`,
    /// but for one command.
    std::size_t rewind_bytes_used() const;
    std::size_t snapshot_count() const { return history_.size(); }

  private:
    bool advance();
    void obey_now(const Command& command);
    void obey_log_of_this_tick();
    bool restore(std::uint64_t tick);
    void forget_future();
    void log(const Command& command);
    void bound_log();
    void mark();
    void forget_marks_from(std::uint64_t tick);
    std::size_t log_bytes() const;
    void use_solver(const SolverSettings& settings);

    Scene scene_;
    SolverSettings first_solver_;
    Solver solver_;
    World world_;
    GameState game_;
    std::vector<Contact> contacts_;
    std::function<bool()> keep_going_;
    TickOutcome outcome_ = TickOutcome::done;

    /// Where the way back ends, before the commands of log_ at its tick; none: the scene itself.
    std::optional<Snapshot> base_;
    History history_;
    std::vector<TimedCommand> log_;
    std::size_t obeyed_ = 0;  ///< commands of log_ that world_ has obeyed
    std::vector<FingerprintMark> marks_;
    std::uint64_t latest_ = 0;
    bool keeps_all_commands_ = false;
    bool is_following_ = false;
    std::optional<std::string> fault_;
    std::size_t rewind_bytes_ = 0;
};

}  // namespace carom
