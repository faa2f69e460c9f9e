#pragma once

#include <optional>
#include <string>

/// What the game tells the player in the last line: a message that fades, and a problem that stays.
namespace carom {

class Messages {
  public:
    void say(std::string message) { set(std::move(message), false); }
    void complain(std::string message) { set(std::move(message), true); }
    /// Stays until the next call; none: all is well. For the errors of a level that is watched.
    void set_problem(std::optional<std::string> problem) { problem_ = std::move(problem); }

    /// Lets time pass, s. True: the message has just faded.
    bool fade(double seconds);
    /// Seconds until the message fades; none: there is none.
    std::optional<double> seconds_left() const;

    struct Line {
        std::string text;
        bool is_error = false;
    };
    /// What is to be read now; none: nothing.
    std::optional<Line> line() const;

  private:
    void set(std::string message, bool is_error);

    Line message_;
    double seconds_left_ = 0.0;
    std::optional<std::string> problem_;
};

}  // namespace carom
