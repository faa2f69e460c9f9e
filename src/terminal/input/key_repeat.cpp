#include "terminal/input/key_repeat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace carom {
namespace {

// s. Nobody presses a key twice within `too_fast_for_a_finger`; no terminal repeats sooner than
// `least_delay` after the press.
constexpr double too_fast_for_a_finger = 0.1;
constexpr double least_delay = 0.18;
// Until the terminal is known.
constexpr double most_delay = 0.75;
constexpr double unknown_period = 0.2;

constexpr double least_margin = 0.04;
constexpr double most_lateness = 0.12;
/// A longer gap between repeats means that the key was let go, whatever the link.
constexpr double longest_gap = 0.3;

// A held key is recognised by so many gaps after the first.
constexpr std::size_t gaps_of_hold = 5;
constexpr double longest_period = 0.1;  // s, their mean; a finger needs longer
constexpr double longest_delay = 1.5;   // s
/// The share of the lateness that each repeat leaves.
constexpr double memory = 0.98;

}  // namespace

void KeyRepeat::remember(const KeyRepeatTimes& times) {
    if (!is_observed_) times_ = times;
}

KeyRepeat::Meaning KeyRepeat::take(char32_t key, double time) {
    const double gap = time - last_time_;
    Meaning meaning = meaning_of(key, gap);
    if (last_key_ != key)
        gaps_.clear();
    else if (learn(gap))
        meaning = Meaning::repeat;
    if (meaning == Meaning::press) {
        repeats_ = 0;
        unconfirmed_ = 0.0;
    } else {
        lateness_ = std::clamp(unconfirmed_, memory * lateness_, most_lateness);
        unconfirmed_ = times_ && repeats_ > 0 ? gap - times_->period : 0.0;
        ++repeats_;
    }
    last_key_ = key;
    last_time_ = time;
    return meaning;
}

KeyRepeat::Meaning KeyRepeat::meaning_of(char32_t key, double gap) const {
    if (last_key_ != key) return Meaning::press;
    const auto repeat_if = [](bool is_repeat) {
        return is_repeat ? Meaning::repeat : Meaning::press;
    };
    if (gap < too_fast_for_a_finger) return Meaning::repeat;
    if (repeats_ > 0) return repeat_if(gap < longest_repeat_gap());
    if (!times_) return repeat_if(gap > least_delay && gap < most_delay);
    return repeat_if(std::abs(gap - times_->delay) < margin());
}

// Looks for the gaps of a held key: a long one, then short ones. Returns whether it is one.
bool KeyRepeat::learn(double gap) {
    gaps_.push_back(gap);
    if (gaps_.size() > gaps_of_hold + 1) gaps_.erase(gaps_.begin());
    if (gaps_.size() <= gaps_of_hold) return false;
    const double delay = gaps_.front();
    const double total = std::accumulate(gaps_.begin() + 1, gaps_.end(), 0.0);
    const double period = total / static_cast<double>(gaps_of_hold);
    const double longest = *std::max_element(gaps_.begin() + 1, gaps_.end());
    if (delay < least_delay || delay > longest_delay || delay < 1.5 * longest ||
        period > longest_period)
        return false;
    const bool is_same = is_observed_ && std::abs(delay - times_->delay) < most_lateness;
    lateness_ = std::clamp(longest - period, is_same ? lateness_ : 0.0, most_lateness);
    // The first repeat may be early or late, too: the longer of two like delays is safe.
    times_ = {is_same ? std::max(delay, 0.5 * (delay + times_->delay)) : delay, period};
    is_observed_ = true;
    return true;
}

// Twice the margin: a finger that comes back within 0.3 s must not be taken for a repeat, which
// would hold its button for a moment only.
double KeyRepeat::longest_repeat_gap() const {
    return times_ ? std::min(longest_gap, times_->period + 2.0 * margin()) : longest_gap;
}

double KeyRepeat::margin() const {
    return std::max(least_margin, 2.0 * lateness_);
}

double KeyRepeat::tap_length() const {
    return times_ ? times_->delay + margin() : most_delay;
}

double KeyRepeat::may_be_held_until() const {
    if (!last_key_) return -std::numeric_limits<double>::infinity();
    if (repeats_ == 0) return last_time_ + tap_length();
    return last_time_ + (times_ ? times_->period + margin() : unknown_period);
}

}  // namespace carom
