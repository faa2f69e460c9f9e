#pragma once

#include <optional>
#include <span>

#include "carom/context/playback_clock.h"
#include "game/session/session.h"
#include "lab/compare/butterfly.h"

/// The butterfly in play: 200 copies of the game that begin a hair apart.
namespace carom {

/// Begins where a session is, and follows it: the same ticks, the same commands, the same solver.
/// When the session goes back, there is nothing to follow any more, and it begins anew there.
class Ensemble {
  public:
    static constexpr std::size_t copy_count = 200;
    /// Most that a ball is moved each way at the start, in mean radii.
    static constexpr double nudge_radii = 1e-9;

    explicit Ensemble(const Session& session);

    /// To the session's tick: true. `may_go_on` is asked between copies and `keep_going` within
    /// long ticks; where one of them says no, the rest is left to the next call.
    bool follow(const Session& session, const MayGoOn& may_go_on, const KeepGoing& keep_going);
    bool is_behind(const Session& session) const { return tick_ != session.world().tick; }

    std::span<const World> copies() const { return butterfly_.copies(); }
    /// See Butterfly::spread; in radii, of the last tick that all copies have done.
    double spread() const { return spread_; }
    /// When they had first spread to a radius, s of the game.
    const std::optional<double>& time_of_a_radius() const { return time_of_a_radius_; }
    /// When they began, s of the game.
    double start_time() const { return start_.time(); }

  private:
    World start_;
    SolverSettings start_solver_;
    Butterfly butterfly_;
    std::uint64_t tick_ = 0;  ///< that all copies have done
    bool is_within_tick_ = false;
    double spread_ = 0.0;
    std::optional<double> time_of_a_radius_;
};

}  // namespace carom
