#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "game/session/session.h"

/// The playback clock turns wall-clock time into ticks of fixed length, at any frame rate.
namespace carom {

/// Asked between ticks: whether there is time for another tick before the next frame.
using MayGoOn = std::function<bool()>;
/// Asked within a long tick: whether to continue it; see Session::set_keep_going.
using KeepGoing = std::function<bool()>;

class PlaybackClock {
  public:
    bool is_paused() const { return is_paused_; }
    /// Pausing ends a search and discards the fraction of a tick that was due.
    void pause(bool paused);

    /// The speed relative to the level's own, from 1/100 to 1000 in steps of about two.
    double speed() const;
    void slower();
    void faster();
    /// Ends hurry(), too.
    void normal();
    /// Goes on at twenty times the level's own speed, until normal(), slower() or faster().
    void hurry();
    bool is_hurrying() const { return is_hurrying_; }

    /// Runs as fast as possible to the next collision (Session::step_to_collision), then pauses.
    void seek_collision();
    bool is_seeking() const { return seeking_ > 0; }

    /// Lets `seconds` of wall-clock time pass and returns the number of ticks computed. When
    /// `may_go_on` returns false, ticks that are still due are dropped: the game then runs and
    /// reports itself slower than real time, instead of falling ever further behind.
    std::uint64_t advance(Session& session, double seconds, const MayGoOn& may_go_on);

    /// Ticks per second of wall-clock time, measured over the last half second or more.
    double ticks_per_second() const { return measured_; }
    /// Whether ticks were dropped within the last half second.
    bool is_behind() const { return is_behind_; }
    /// The contact that the last search found; none: it failed, or goes on.
    const std::optional<Contact>& found() const { return found_; }
    /// Whether the last search failed; reset by the next one.
    bool search_failed() const { return search_failed_; }

  private:
    std::uint64_t seek(Session& session, const MayGoOn& may_go_on);
    void measure(double seconds, std::uint64_t ticks, bool dropped);

    bool is_paused_ = false;
    int gear_ = 0;  ///< 0 is the level's own speed
    bool is_hurrying_ = false;
    double due_ = 0.0;           ///< ticks, < 1 between calls
    std::uint64_t seeking_ = 0;  ///< ticks left for a search
    bool search_failed_ = false;
    std::optional<Contact> found_;

    double window_seconds_ = 0.0;
    std::uint64_t window_ticks_ = 0;
    bool window_dropped_ = false;
    double measured_ = 0.0;
    bool is_behind_ = false;
};

}  // namespace carom
