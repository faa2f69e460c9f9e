#pragma once

#include <cstdint>
#include <optional>
#include <vector>

/// Whether a key is still held, on terminals that report presses and repeats but no releases.
namespace carom {

/// How a terminal repeats a held key.
struct KeyRepeatTimes {
    double delay = 0.0;   ///< s from the press to the first repeat
    double period = 0.0;  ///< s between repeats, on average

    friend bool operator==(const KeyRepeatTimes&, const KeyRepeatTimes&) = default;
};

/// Tells presses from repeats by their times of arrival, and learns the terminal's delay and period
/// from every key that is held for six repeats. Typical: 250 ms and 33 ms, 500 and 33, xterm's 660
/// and 40; through SSH each may come some 50 ms late.
///
/// A terminal repeats only the key that was pressed last. Of the others that are held nothing is
/// heard until they are pressed again, whether or not they are let go.
class KeyRepeat {
  public:
    /// Starts from what was learnt earlier. Does nothing once this terminal has been observed.
    void remember(const KeyRepeatTimes& times);

    enum class Meaning : std::uint8_t { press, repeat };
    /// What this arrival of `key` means. `time`: s on the clock of all other calls, not before the
    /// last one.
    Meaning take(char32_t key, double time);

    /// The time until which the key that arrived last may still be held: a repeat of it would come
    /// before. The margin over the delay or the period is twice the delays seen, 40 ms at least.
    /// Until the terminal is known: 0.75 s after a press and 0.2 s after a repeat. Minus infinity
    /// before the first key.
    double may_be_held_until() const;

    /// The time that a tap counts as held, s.
    double tap_length() const;
    /// None: not known yet.
    const std::optional<KeyRepeatTimes>& times() const { return times_; }

  private:
    Meaning meaning_of(char32_t key, double gap) const;
    bool learn(double gap);
    double longest_repeat_gap() const;
    double margin() const;

    std::optional<KeyRepeatTimes> times_;
    bool is_observed_ = false;  ///< `times_` was learnt here
    double lateness_ = 0.0;     ///< the most by which an arrival was late, forgotten slowly, s
    double unconfirmed_ = 0.0;  ///< of the last repeat: noted once another follows, s

    std::optional<char32_t> last_key_;
    double last_time_ = 0.0;
    int repeats_ = 0;           ///< of the last press
    std::vector<double> gaps_;  ///< before the last arrivals of `last_key_`, the oldest first, s
};

}  // namespace carom
