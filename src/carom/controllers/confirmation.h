#pragma once

#include <string_view>

namespace carom {

/// A question whose answer is the key that led to it, pressed again at once: what that key does
/// cannot be taken back.
class Confirmation {
  public:
    /// A key of this action was pressed. Pre: the name lasts, as those of the table of actions do.
    void press(std::string_view action) {
        is_given_ = seconds_left_ > 0.0 && action == asked_;
        seconds_left_ = 0.0;
        asked_ = action;
    }
    /// The last press was a yes.
    bool is_given() const { return is_given_; }
    /// The last press leads to the question.
    void ask() { seconds_left_ = patience; }
    void pass(double seconds) { seconds_left_ -= seconds; }

  private:
    static constexpr double patience = 3.0;  // s

    std::string_view asked_;
    double seconds_left_ = 0.0;
    bool is_given_ = false;
};

}  // namespace carom
