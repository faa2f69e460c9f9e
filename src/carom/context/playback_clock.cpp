#include "carom/context/playback_clock.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace carom {
namespace {

constexpr double gears[] = {0.01, 0.02, 0.05, 0.1,  0.2,   0.5,   1.0,   2.0,
                            5.0,  10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};
constexpr int normal_gear = 6;
constexpr double hurrying_speed = 20.0;
constexpr int last_gear = static_cast<int>(std::size(gears)) - 1;

/// A search stops after this much game time, s.
constexpr double longest_search = 600.0;
/// The window over which the speed is measured, s of wall-clock time.
constexpr double window = 0.5;

}  // namespace

void PlaybackClock::pause(bool paused) {
    is_paused_ = paused;
    due_ = 0.0;
    seeking_ = 0;
}

double PlaybackClock::speed() const {
    return is_hurrying_ ? hurrying_speed : gears[gear_ + normal_gear];
}

void PlaybackClock::hurry() {
    pause(false);
    is_hurrying_ = true;
}

void PlaybackClock::slower() {
    is_hurrying_ = false;
    gear_ = std::max(gear_ - 1, -normal_gear);
}

void PlaybackClock::faster() {
    is_hurrying_ = false;
    gear_ = std::min(gear_ + 1, last_gear - normal_gear);
}

void PlaybackClock::normal() {
    is_hurrying_ = false;
    gear_ = 0;
}

void PlaybackClock::seek_collision() {
    pause(true);
    search_failed_ = false;
    found_.reset();
    seeking_ = std::numeric_limits<std::uint64_t>::max();
}

std::uint64_t PlaybackClock::advance(Session& session, double seconds, const MayGoOn& may_go_on) {
    if (is_seeking()) return seek(session, may_go_on);
    if (is_paused_) return 0;
    due_ += seconds * speed() * session.world().rate();
    std::uint64_t ticks = 0;
    bool dropped = false;
    while (due_ >= 1.0) {
        if (ticks > 0 && !may_go_on()) {
            dropped = true;
            due_ -= std::floor(due_);
            break;
        }
        if (!session.step_forward()) {
            if (session.is_at_end()) pause(true);
            break;
        }
        ++ticks;
        due_ -= 1.0;
    }
    measure(seconds, ticks, dropped);
    return ticks;
}

std::uint64_t PlaybackClock::seek(Session& session, const MayGoOn& may_go_on) {
    const double most = longest_search * session.world().rate();
    if (static_cast<double>(seeking_) > most) seeking_ = static_cast<std::uint64_t>(most) + 1;
    std::uint64_t ticks = 0;
    do {
        ++ticks;
        found_ = session.step_to_collision(1);
        if (found_) {
            seeking_ = 0;
            return ticks;
        }
        if (session.is_at_end()) {
            seeking_ = 0;
            return ticks;
        }
        if (session.outcome() == TickOutcome::cancelled) return ticks;
        if (--seeking_ == 0) search_failed_ = true;
    } while (is_seeking() && may_go_on());
    return ticks;
}

void PlaybackClock::measure(double seconds, std::uint64_t ticks, bool dropped) {
    window_seconds_ += seconds;
    window_ticks_ += ticks;
    window_dropped_ = window_dropped_ || dropped;
    if (window_seconds_ < window) return;
    measured_ = static_cast<double>(window_ticks_) / window_seconds_;
    is_behind_ = window_dropped_;
    window_seconds_ = 0.0;
    window_ticks_ = 0;
    window_dropped_ = false;
}

}  // namespace carom
