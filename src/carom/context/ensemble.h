#pragma once

#include <optional>
#include <span>

#include "carom/context/playback_clock.h"
#include "game/session/session.h"
#include "lab/compare/world_ensemble.h"

/// An ensemble: 200 copies of the game from slightly perturbed starts, which show how fast the game
/// loses the memory of its start.
namespace carom {

/// Starts from the state of a session and follows it, with the same ticks, commands and solver.
/// When the session goes back, the ensemble restarts there.
class Ensemble {
  public:
    static constexpr std::size_t copy_count = 200;
    /// The largest displacement of a ball along each axis at the start, in mean radii.
    static constexpr double nudge_radii = 1e-9;

    explicit Ensemble(const Session& session);

    /// Computes ticks up to the session's. Returns false if stopped: `may_go_on` is asked between
    /// copies and `keep_going` within long ticks, and the next call continues.
    bool follow(const Session& session, const MayGoOn& may_go_on, const KeepGoing& keep_going);
    bool is_behind(const Session& session) const { return tick_ != session.world().tick(); }

    std::span<const World> copies() const { return butterfly_.copies(); }
    /// WorldEnsemble::spread at the last tick that all copies have completed, in radii.
    double spread() const { return spread_; }
    /// The game time at which the spread first reached a radius, s.
    const std::optional<double>& time_of_a_radius() const { return time_of_a_radius_; }
    /// The game time of the start, s.
    double start_time() const { return start_.time(); }

  private:
    World start_;
    SolverSettings start_solver_;
    WorldEnsemble butterfly_;
    std::uint64_t tick_ = 0;  ///< completed by all copies
    bool is_within_tick_ = false;
    double spread_ = 0.0;
    std::optional<double> time_of_a_radius_;
};

}  // namespace carom
