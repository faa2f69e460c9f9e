#pragma once

#include <optional>
#include <string>

/// Messages in the last line of the window: one that fades, and a problem that stays.
namespace carom {

class Messages {
  public:
    void say(std::string message) { set(std::move(message), false); }
    void complain(std::string message) { set(std::move(message), true); }
    /// The problem stays until the next call; none clears it. For the errors of a level under
    /// --watch.
    void set_problem(std::optional<std::string> problem) { problem_ = std::move(problem); }

    /// Advances the timer, s. Returns true if the message has just faded.
    bool fade(double seconds);
    /// Seconds until the message fades; none: there is no message.
    std::optional<double> seconds_left() const;

    struct Line {
        std::string text;
        bool is_error = false;
    };
    /// The line to show now; none: nothing.
    std::optional<Line> line() const;

  private:
    void set(std::string message, bool is_error);

    Line message_;
    double seconds_left_ = 0.0;
    std::optional<std::string> problem_;
};

}  // namespace carom
