#pragma once

#include <cstdint>
#include <functional>

#include "game/session/session.h"

/// How fast a game's own time passes for a player: fixed ticks, whatever the frame rate.
namespace carom {

/// Asked between ticks: whether there is time for another before the next frame.
using MayGoOn = std::function<bool()>;
/// Asked within a long tick: whether it may go on; see Session::set_keep_going.
using KeepGoing = std::function<bool()>;

class PlaybackClock {
  public:
    bool is_paused() const { return is_paused_; }
    /// Pausing ends a search, and forgets the part of a tick that was due.
    void pause(bool paused);

    /// Times the level's own speed, from 1/100 to 1000 in steps of about two.
    double speed() const;
    void slower();
    void faster();
    void normal();

    /// Runs, as fast as it can, to the next collision (Session::step_to_collision), then pauses.
    void seek_collision();
    bool is_seeking() const { return seeking_ > 0; }

    /// Lets `seconds` of the player's time pass. When `may_go_on` says no, the ticks that are still
    /// due are dropped: the game is then slower than it should be, and says so, instead of falling
    /// ever further behind. Returns the number of ticks done.
    std::uint64_t advance(Session& session, double seconds, const MayGoOn& may_go_on);

    /// Ticks a second of the player's time, measured over the last half second or more.
    double ticks_per_second() const { return measured_; }
    /// Ticks were dropped within the last half second.
    bool is_behind() const { return is_behind_; }
    /// How a search ended; reset by the next one.
    bool search_failed() const { return search_failed_; }

  private:
    std::uint64_t seek(Session& session, const MayGoOn& may_go_on);
    void measure(double seconds, std::uint64_t ticks, bool dropped);

    bool is_paused_ = false;
    int gear_ = 0;               ///< 0 is the level's own speed
    double due_ = 0.0;           ///< ticks, < 1 between calls
    std::uint64_t seeking_ = 0;  ///< ticks that a search may still take
    bool search_failed_ = false;

    double window_seconds_ = 0.0;
    std::uint64_t window_ticks_ = 0;
    bool window_dropped_ = false;
    double measured_ = 0.0;
    bool is_behind_ = false;
};

}  // namespace carom
