#include "golden/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

namespace carom::test {
namespace {

constexpr std::string_view digits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-";

std::uint64_t window_of(std::uint64_t ticks) {
    return std::max<std::uint64_t>(1,
                                   (ticks + TraceRecorder::windows - 1) / TraceRecorder::windows);
}

char digest(std::initializer_list<double> numbers) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const double number : numbers) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return digits[static_cast<std::size_t>(hash >> 58)];
}

struct Row {
    std::string_view ball, x, y, digests;
};

// Pre: a line of a trace.
Row row_of(std::string_view line) {
    const std::size_t first = line.find(' '), comma = line.find(',', first);
    const std::size_t second = line.find(' ', comma);
    return {line.substr(0, first), line.substr(first + 1, comma - first - 1),
            line.substr(comma + 1, second - comma - 1), line.substr(second + 1)};
}

double number_in(std::string_view text) {
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

TraceRecorder::TraceRecorder(const World& start, std::uint64_t ticks)
    : window_(window_of(ticks)),
      stride_(std::max<std::uint32_t>(
          1, static_cast<std::uint32_t>(start.balls().size() + most_balls - 1) / most_balls)) {}

void TraceRecorder::note(const World& world) {
    if (world.tick() == 0 || world.tick() % window_ != 0) return;
    for (auto& [ball, noted] : balls_)
        noted.digests += '.';
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const std::uint32_t ball = number(world.balls().id[i]);
        if (ball % stride_ != 0) continue;
        Ball& noted = balls_.try_emplace(ball, Ball{{}, absent_ + '.'}).first->second;
        const Vec2 position = world.balls().position[i], velocity = world.balls().velocity[i];
        noted.position = position;
        const double spin = world.model().spin ? world.balls().spin[i] : 0.0;
        noted.digests.back() = digest({position.x, position.y, velocity.x, velocity.y, spin});
    }
    absent_ += '.';
}

std::vector<std::string> TraceRecorder::lines() const {
    std::vector<std::string> lines;
    for (const auto& [ball, noted] : balls_)
        lines.push_back(
            fmt::format("{} {},{} {}", ball, noted.position.x, noted.position.y, noted.digests));
    return lines;
}

std::optional<std::string> difference(const std::vector<std::string>& golden,
                                      const std::vector<std::string>& now, std::uint64_t ticks) {
    if (golden == now) return std::nullopt;
    if (golden.size() != now.size())
        return fmt::format("there are traces of {} balls, and were of {}", now.size(),
                           golden.size());
    std::size_t earliest = std::string::npos;
    std::string first;
    int elsewhere = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (golden[i] == now[i]) continue;
        ++elsewhere;
        const Row before = row_of(golden[i]), after = row_of(now[i]);
        const auto different = std::ranges::mismatch(before.digests, after.digests);
        const auto window = static_cast<std::size_t>(different.in1 - before.digests.begin());
        if (window >= earliest) continue;
        earliest = window;
        const std::uint64_t length = window_of(ticks);
        const double dx = number_in(after.x) - number_in(before.x);
        const double dy = number_in(after.y) - number_in(before.y);
        first = fmt::format(
            "ball {} is elsewhere, or faster or slower, since a tick of {} to {}; "
            "at the end by {:.3g},{:.3g}",
            after.ball, window * length + 1, (window + 1) * length, dx, dy);
    }
    return fmt::format("{} ({} of {} balls differ)", first, elsewhere, now.size());
}

}  // namespace carom::test
