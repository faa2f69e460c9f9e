#include "carom/context/messages.h"

#include <limits>
#include <utility>

namespace carom {
namespace {

/// The time that a message stays visible, s.
constexpr double message_time = 4.0;

}  // namespace

void Messages::say(std::string message, std::optional<Vec2> place) {
    message_ = {std::move(message), false, place};
    seconds_left_ = message_time;
    is_new_ = true;
}

void Messages::complain(std::string message, std::optional<Vec2> place) {
    message_ = {std::move(message), true, place};
    seconds_left_ = message_time;
    is_new_ = true;
}

void Messages::keep_message() {
    if (seconds_left_ > 0.0) seconds_left_ = std::numeric_limits<double>::infinity();
}

void Messages::set_problem(std::vector<std::string> lines) {
    problem_ = std::move(lines);
}

bool Messages::fade(double seconds) {
    if (seconds_left_ <= 0.0 || std::exchange(is_new_, false)) return false;
    seconds_left_ -= seconds;
    return seconds_left_ <= 0.0;
}

std::optional<double> Messages::seconds_left() const {
    return seconds_left_ > 0.0 ? std::optional(seconds_left_) : std::nullopt;
}

std::optional<Messages::Line> Messages::line() const {
    if (!prompt_.empty()) return Line{prompt_, false, std::nullopt};
    if (seconds_left_ > 0.0) return message_;
    if (problem_.empty()) return std::nullopt;
    Line lines{"", true, std::nullopt};
    for (const std::string& line : problem_)
        lines.text += (lines.text.empty() ? "" : "\n") + line;
    return lines;
}

}  // namespace carom
