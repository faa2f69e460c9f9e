#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

/// Messages above the status lines: one that fades, and a problem that stays.
namespace carom {

class Messages {
  public:
    /// `place`: in the world, where it happened; marked while the message is shown.
    void say(std::string message, std::optional<Vec2> place = {});
    void complain(std::string message, std::optional<Vec2> place = {});
    /// The message stays until the player acts, however long that takes.
    void keep_message();
    /// The lines of the problem stay until the next call; none clear it. For the errors of a level
    /// under --watch.
    void set_problem(std::vector<std::string> lines);
    /// The player acts: what the last message spoke of is over. Complaints stay until they fade, as
    /// the player may not have read them yet.
    void end_message() {
        if (!message_.is_error) seconds_left_ = 0.0;
    }
    /// Nothing is in the way of the held body any more.
    void end_obstacle() {
        if (message_.is_error && message_.place) seconds_left_ = 0.0;
    }
    /// A question to the player, shown before everything else until it is answered; empty: none.
    void set_prompt(std::string prompt) { prompt_ = std::move(prompt); }
    /// The problem's lines.
    const std::vector<std::string>& problem() const { return problem_; }

    /// Advances the timer, s. Returns true if the message has just faded. The first call for a
    /// message does not count, since its time began before the message came up: a long tick, at
    /// the end of which there is something to say.
    bool fade(double seconds);
    /// Seconds until the message fades; none: there is no message.
    std::optional<double> seconds_left() const;

    struct Line {
        std::string text;
        bool is_error = false;
        std::optional<Vec2> place{};
    };
    /// The message to show now, or the lines of the problem, joined by line ends; none: nothing.
    std::optional<Line> line() const;

  private:
    Line message_;
    double seconds_left_ = 0.0;
    bool is_new_ = false;
    std::vector<std::string> problem_;
    std::string prompt_;
};

}  // namespace carom
