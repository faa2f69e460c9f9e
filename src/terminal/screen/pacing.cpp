#include "terminal/screen/pacing.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double blind_interval = 1.0 / 20.0;     // s; about what a 9600 baud line carries
constexpr double blind_after = 0.5;               // s without a first answer
constexpr double stalled_after = 2.0;             // s without any further answer
constexpr double urgent_interval = 0.004;         // s; a drag may send a thousand reports a second
constexpr double stalled_urgent_interval = 0.25;  // s
constexpr double early = 0.001;                   // s by which a frame may be early

constexpr std::size_t usual_window = 2;
constexpr std::size_t most_kept = 256;  // unanswered frames remembered
constexpr double short_queue = 0.015;   // s; a frame that waited no longer met no queue
constexpr double long_queue = 0.035;    // s; a frame that waited longer met too many others
// A single frame under way, whose queue is so many round trips, keeps the link busy for 70 % of the
// time. A second one would add little, and be twice as old.
constexpr double busy_alone = 2.5;
constexpr double contentment = 5.0;   // s before the window may grow again
constexpr double path_memory = 10.0;  // s after which the shortest round trip is measured again

}  // namespace

Pacing::Pacing(const PacingOptions& options) : options_(options) {}

bool Pacing::is_blind(double now) const {
    return !has_answers_ && !sent_.empty() && now - sent_.front().at > blind_after;
}

bool Pacing::is_stalled(double now) const {
    if (!has_answers_ || sent_.empty()) return false;
    return has_asked_again_ || now - sent_.front().at > stalled_after;
}

double Pacing::interval(double now) const {
    const double wanted = 1.0 / options_.frames_per_second;
    return is_blind(now) ? std::max(wanted, blind_interval) : wanted;
}

bool Pacing::may_draw(double now, bool urgent) const {
    const double since = now - last_drawn_;
    if (is_stalled(now)) return since >= (urgent ? stalled_urgent_interval : stalled_after);
    if (!is_blind(now) && sent_.size() >= window()) return false;
    if (now < bytes_due_) return false;
    return now >= next_due_ - early || (urgent && since >= urgent_interval);
}

double Pacing::seconds_to_frame(double now, bool urgent) const {
    if (is_stalled(now)) {
        const double pause = urgent ? stalled_urgent_interval : stalled_after;
        return std::max(0.0, last_drawn_ + pause - now);
    }
    if (!is_blind(now) && sent_.size() >= window()) {
        const double longest = has_answers_ ? stalled_after : blind_after;
        return std::max(early, sent_.front().at + longest - now);
    }
    const double due = urgent ? std::min(next_due_, last_drawn_ + urgent_interval) : next_due_;
    return std::max({0.0, due - now, bytes_due_ - now});
}

void Pacing::drawn(double now, std::size_t bytes) {
    const double period = interval(now);
    const double late = now - next_due_;
    // A frame in time keeps the rhythm; an urgent frame, or one after a break, restarts it.
    next_due_ = late >= -early && late < period ? next_due_ + period : now + period;
    last_drawn_ = now;
    if (is_stalled(now)) {  // frames not answered by now never will be
        lost_ += sent_.size();
        sent_.clear();
        window_ = usual_window;
        has_asked_again_ = true;
    }
    sent_.push_back({.at = now, .was_alone = sent_.empty()});
    ++drawn_;
    if (sent_.size() > most_kept) sent_.pop_front();
    if (options_.bytes_per_second > 0.0) {
        bytes_due_ =
            std::max(bytes_due_, now) + static_cast<double>(bytes) / options_.bytes_per_second;
    }
}

void Pacing::asked(double now) {
    sent_.push_back({.at = now, .is_query = true});
    ++drawn_;
}

void Pacing::answered(std::size_t total, double now) {
    // A frame that was counted as lost may have been answered after all.
    lost_ = std::min(lost_, drawn_ - std::min(drawn_, total));
    while (!sent_.empty() && drawn_ - sent_.size() < total + lost_) {
        const Sent frame = sent_.front();
        sent_.pop_front();
        has_answers_ = true;
        has_asked_again_ = false;
        learn(frame, now);
    }
}

// A round trip about as short as the shortest met no queue, so there is room for more frames. A
// long one waited behind carom's own frames, or behind other traffic.
void Pacing::learn(const Sent& sent, double now) {
    round_trip_ = std::max(1.0e-6, now - sent.at);
    if (sent.is_query) {
        shortest_trip_ = round_trip_;
        is_probing_ = false;
        return;
    }
    const std::size_t number = drawn_ - sent_.size();  // of what is answered or lost
    const bool is_first = shortest_trip_ <= 0.0;
    shortest_trip_ = is_first ? round_trip_ : std::min(shortest_trip_, round_trip_);
    if (is_first && round_trip_ > short_queue) is_probing_ = true;
    const double queue = round_trip_ - shortest_trip_;
    if (queue <= short_queue) seen_short_ = now;
    if (now - seen_short_ > path_memory) {  // the link may have become slower
        is_probing_ = true;
        seen_short_ = now;
    }
    const double busy = busy_alone * static_cast<double>(window_) * shortest_trip_;
    const std::size_t least = queue > busy ? 1 : usual_window;
    const double useful = std::ceil(shortest_trip_ * options_.frames_per_second) + 1.0;
    const auto most = std::max(usual_window, static_cast<std::size_t>(std::min(useful, 64.0)));
    const bool is_limit = sent_.size() + 1 >= window_;
    // The effect of a change shows only once a frame that was sent after it has been answered.
    if (number <= changed_at_ || (sent.was_alone && window_ > 1)) return;
    const std::size_t before = window_;
    if (queue > long_queue) {
        // As many frames as the link holds without a queue; then no growth for a while.
        window_ =
            static_cast<std::size_t>(static_cast<double>(window_) * shortest_trip_ / round_trip_);
        may_grow_at_ = now + contentment;
    } else if (queue <= short_queue && is_limit && now >= may_grow_at_) {
        window_ += std::max<std::size_t>(1, window_ / 3);
    }
    window_ = std::clamp(window_, least, most);
    if (window_ != before) changed_at_ = drawn_ + (window_ > before ? window_ - before : 0);
}

}  // namespace carom
