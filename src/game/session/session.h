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
#include "game/session/fingerprint_log.h"
#include "game/session/game_state.h"
#include "game/session/history.h"
#include "level/scene/scene.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// A game in progress: a scene, the player's commands, and rewinding.
namespace carom {

/// Invariant: the present is the world after the present tick and after all commands of that tick.
/// To go back, a session restores the nearest earlier snapshot and computes forward with the logged
/// commands. That gives the same bits, because the core is deterministic. src/game/README.md
/// describes the whole process.
///
/// The memory for rewinding is bounded (`rewind_bytes`). Snapshots are dense near the present and
/// sparse far away, so going back by n ticks computes about n ticks at most. The scene itself is
/// the start, so one can normally go back to tick 0. If the log alone outgrows half of the memory
/// (about 100 bytes a command; with 64 MiB, half an hour of uninterrupted dragging), its older half
/// is dropped. earliest() then says how far one can go back.
class Session {
  public:
    static constexpr std::size_t default_rewind_bytes = std::size_t{64} << 20;

    /// `rewind_bytes`: the limit of memory for rewinding (snapshots and commands).
    /// Pre: solver.kind is one of solvers_available().
    Session(Scene scene, const SolverSettings& solver,
            std::size_t rewind_bytes = default_rewind_bytes);
    // Defined in session.cpp: the code for so many members is then compiled once.
    Session(Session&& other) noexcept;
    Session& operator=(Session&& other) noexcept;
    ~Session();

    const Scene& scene() const { return scene_; }
    const World& world() const { return world_; }
    /// The state of the game's rules.
    const GameState& game() const { return game_; }
    const SolverSettings& solver() const { return solver_.settings(); }
    /// Contacts of the last tick; empty at the start and after a restart.
    std::span<const Contact> contacts() const { return contacts_; }

    /// The cells in which the solver looked for neighbours in the tick that it computed last.
    /// Before the first one, a single cell of side 1: CellFrame{}.
    const CellFrame& cells() const { return solver_.cells(); }

    /// Executes a command at once, before the next tick, and logs it with the present tick. If the
    /// present is behind latest(), the logged future is discarded first, and all bodies and buttons
    /// that are held are released, since the commands that would release them are in that future.
    /// Returns why the command is refused, as a sentence; none if it was executed.
    std::optional<std::string> apply(const Command& command);

    /// One tick forward. Behind latest(), this replays the logged commands. Returns false, and
    /// changes nothing, at the end of a recording that it plays, and if the tick was cancelled.
    bool step_forward();
    /// One tick back, to exactly the state that was. False at earliest().
    bool step_back();
    /// Goes to a tick in earliest()..latest() with as few ticks as possible. False if it is
    /// outside, and if a tick on the way was cancelled: the present is then before it.
    bool go_to(std::uint64_t tick);
    /// Forward to the first tick with a contact of two bodies that had none in the tick before; at
    /// most `limit` ticks. Returns the first such contact of that tick; none: there was no such
    /// tick.
    std::optional<Contact> step_to_collision(std::uint64_t limit);
    /// Goes back to just before the last gesture at or before the present (continues_gesture) and
    /// forgets it with everything after it. False when there is nothing left to undo.
    bool undo();

    /// `keep_going` is asked now and then within a long tick; false cancels the tick.
    void set_keep_going(std::function<bool()> keep_going) { keep_going_ = std::move(keep_going); }
    /// Called after each tick that is computed, also on the way back to an earlier one, before the
    /// commands of that tick.
    void set_after_tick(std::function<void(const Session&)> after_tick) {
        after_tick_ = std::move(after_tick);
    }
    /// How the last tick ended.
    TickOutcome outcome() const { return outcome_; }
    /// For what time stood still in a part of it.
    Standing standing() const { return standing_in(solver_); }

    /// The earliest tick that go_to() accepts, and the latest that has been reached.
    std::uint64_t earliest() const { return base_ ? base_->world.tick() : 0; }
    std::uint64_t latest() const { return latest_; }
    /// Back to the start, without commands; the solver stays.
    void restart();

    /// In the order in which they were applied, including those of the replayable future.
    std::span<const TimedCommand> commands() const { return log_; }
    /// Whether commands() go back to the start, so that the session can be recorded.
    bool is_complete() const { return !base_; }
    /// The fingerprints passed so far. Those of a forgotten future are not among them.
    const FingerprintLog& fingerprints() const { return fingerprints_; }
    /// Lets the log outgrow its share of the memory, so that it stays complete.
    void keep_all_commands() { keeps_all_commands_ = true; }

    /// Plays a recording: step_forward() carries out `commands` and goes no further than `end`;
    /// other commands are refused. Pre: the session is new; the commands are in ascending order of
    /// ticks, none after `end`. `version`: which fingerprints to log, those of the recording.
    void follow(std::vector<TimedCommand> commands, std::uint64_t end,
                int version = fingerprint_version);
    bool is_following() const { return is_following_; }
    /// Whether the recording has been played to its end.
    bool is_at_end() const { return is_following_ && world_.tick() >= latest_; }
    void stop_following() { is_following_ = false; }
    /// Why a command of the recording was refused: a sentence that begins with its tick. The
    /// recording ends there.
    const std::optional<std::string>& fault() const { return fault_; }

    /// The solver at the start: SetSolver commands tell the rest.
    const SolverSettings& first_solver() const { return first_solver_; }

    /// The memory for rewinding, in bytes: snapshots and commands. At most `rewind_bytes` and one
    /// more command.
    std::size_t rewind_bytes_used() const;
    std::size_t snapshot_count() const { return history_.size(); }

  private:
    bool advance();
    void execute_now(const Command& command);
    void execute_log_of_this_tick();
    bool restore(std::uint64_t tick);
    void forget_future();
    void log(const Command& command);
    void bound_log();
    void use_solver(const SolverSettings& settings);

    Scene scene_;
    SolverSettings first_solver_;
    Solver solver_;
    World world_;
    GameState game_;
    std::vector<Contact> contacts_;
    std::function<bool()> keep_going_;
    std::function<void(const Session&)> after_tick_;
    TickOutcome outcome_ = TickOutcome::done;

    /// The earliest state, before the commands of log_ at its tick; none: the scene itself.
    std::optional<Snapshot> base_;
    History history_;
    std::vector<TimedCommand> log_;
    std::size_t executed_ = 0;  ///< commands of log_ that world_ has carried out
    FingerprintLog fingerprints_;
    std::uint64_t latest_ = 0;
    bool keeps_all_commands_ = false;
    bool is_following_ = false;
    std::optional<std::string> fault_;
    std::size_t rewind_bytes_ = 0;
};

}  // namespace carom
