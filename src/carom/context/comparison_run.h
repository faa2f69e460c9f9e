#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "carom/context/playback_clock.h"
#include "game/session/history.h"
#include "game/session/session.h"

/// A comparison run: the game under another solver, for the second half of a split window.
namespace carom {

/// Starts from the state of a session and follows it, with the same ticks and the same commands
/// except changes of the solver. A command that does not apply here, such as one about a ball that
/// is gone, is skipped. A comparison run goes back when the session does. If the session goes back
/// beyond the start of the run, the run restarts there.
class ComparisonRun {
  public:
    /// The first time at which a ball was further than 1 % of its radius from its counterpart in
    /// the session.
    struct Divergence {
        std::uint64_t tick = 0;
        double time = 0.0;  ///< s
        BallId ball{};
        Vec2 place;  ///< of the ball in the session's world
    };

    /// Pre: solver.kind is one of solvers_available().
    ComparisonRun(const Session& session, const SolverSettings& solver);

    /// Computes ticks up to the session's. Returns false if stopped: `may_go_on` is asked between
    /// ticks and `keep_going` within long ticks, and the next call continues. If called after every
    /// tick of the session, it misses no divergence.
    bool follow(const Session& session, const MayGoOn& may_go_on, const KeepGoing& keep_going);

    const SolverSettings& solver() const { return solver_.settings(); }
    const World& world() const { return world_; }
    std::span<const Contact> contacts() const { return contacts_; }
    /// The time of the common start, s.
    double start_time() const { return start_.time(); }
    const std::optional<Divergence>& divergence() const { return divergence_; }

  private:
    void begin(const Session& session);
    void go_back(std::uint64_t tick);
    bool tick(const Session& session, const KeepGoing& keep_going);

    Solver solver_;
    World start_;
    World world_;
    GameState start_game_;
    GameState game_;
    std::vector<Contact> contacts_;
    History history_;
    std::optional<std::uint64_t> obeyed_;  ///< the tick whose commands have been applied to world_
    std::optional<Divergence> divergence_;
};

/// The commands of a session that were given at this tick.
std::span<const TimedCommand> commands_at(const Session& session, std::uint64_t tick);

/// Whether both worlds are in the same state under the same laws.
bool is_same_state(const World& a, const World& b);

}  // namespace carom
