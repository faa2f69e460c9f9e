#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "carom/pool/mouse_stroke.h"
#include "carom/pool/stroke_meter.h"
#include "terminal/input/key_repeat.h"

namespace carom {

/// The stroke in progress in a match, by the meter or with the mouse.
class PersonStroke {
  public:
    /// Lets the player's seconds pass. Returns false when a meter has run out.
    bool pass(double seconds);
    /// Whether a meter has run out so recently that a key may still be meant for it.
    bool has_just_run_out() const;
    /// The player's time after so many further seconds, for MouseStroke and KeyRepeat.
    double time(double after) const { return now_ + after; }

    void start_meter(double speed, double most) { meter_.emplace(speed, most); }
    /// Null: the meter does not run.
    const StrokeMeter* meter() const { return meter_ ? &*meter_ : nullptr; }
    void start_push(const MouseStroke& push) { push_ = push; }
    MouseStroke* push() { return push_ ? &*push_ : nullptr; }
    const MouseStroke* push() const { return push_ ? &*push_ : nullptr; }
    void end() {
        meter_.reset();
        push_.reset();
    }

    /// The last stroke, made with a hand of this level; none: the shot was no stroke.
    void set_last(const std::optional<Stroke>& stroke, int level) {
        last_ = stroke;
        level_ = level;
    }
    /// "stroke 0.31° left, 3.20 m/s": how the last stroke went, without the error of the hand;
    /// empty: there was none.
    std::string last_text(const Look& look) const;

    /// Whether an arrival of `key` is a repeat, on a terminal that does not say so but whose
    /// repeats are known.
    bool repeats(char32_t key, double after);
    void remember(const KeyRepeatTimes& times) { keys_.remember(times); }
    const std::optional<KeyRepeatTimes>& key_repeat() const { return keys_.times(); }

  private:
    double now_ = 0.0;               ///< s of the player's time
    std::optional<double> ran_out_;  ///< when the last meter did
    std::optional<StrokeMeter> meter_;
    std::optional<MouseStroke> push_;
    std::optional<Stroke> last_;
    int level_ = least_hand;  ///< of the hand that made it
    KeyRepeat keys_;
};

/// "a fair hand". Pre: a level of the hand.
std::string_view hand_text(int level);

}  // namespace carom
