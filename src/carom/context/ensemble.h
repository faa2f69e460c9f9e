#pragma once

#include <optional>
#include <span>

#include "carom/context/playback_clock.h"
#include "game/session/session.h"
#include "lab/compare/world_ensemble.h"

/// An ensemble: 200 copies of the game from slightly perturbed starts, which show how fast the game
/// forgets where it started.
namespace carom {

/// Starts from the state of a session and follows it: the same ticks, commands and solver. When the
/// session goes back, the ensemble starts again there.
class Ensemble {
  public:
    static constexpr std::size_t copy_count = 200;
    /// Most that a ball is moved each way at the start, in mean radii.
    static constexpr double nudge_radii = 1e-9;

    explicit Ensemble(const Session& session);

    /// Computes ticks up to the session's: true. `may_go_on` is asked between copies and
    /// `keep_going` within long ticks; where one of them says no, the rest is left to the next
    /// call.
    bool follow(const Session& session, const MayGoOn& may_go_on, const KeepGoing& keep_going);
    bool is_behind(const Session& session) const { return tick_ != session.world().tick(); }

    std::span<const World> copies() const { return butterfly_.copies(); }
    /// See WorldEnsemble::spread; in radii, of the last tick that all copies have completed.
    double spread() const { return spread_; }
    /// When the spread first reached a radius, s of the game.
    const std::optional<double>& time_of_a_radius() const { return time_of_a_radius_; }
    /// The time of the start, s of the game.
    double start_time() const { return start_.time(); }

  private:
    World start_;
    SolverSettings start_solver_;
    WorldEnsemble butterfly_;
    std::uint64_t tick_ = 0;  ///< that all copies have completed
    bool is_within_tick_ = false;
    double spread_ = 0.0;
    std::optional<double> time_of_a_radius_;
};

}  // namespace carom
